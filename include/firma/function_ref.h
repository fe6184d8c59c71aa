// SPDX-License-Identifier: MIT
// A reference to something that can be called: how visitors are handed to the library. Nothing is copied or allocated.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace firma {

template <class Signature>
class FunctionRef;

/// Lives as long as what it was made of: use it for arguments only. A call through it costs one indirect call.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    template <class Function>
        requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
                 std::is_invocable_r_v<Result, Function&, Arguments...>)
    FunctionRef(Function&& function)
        : object_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* object, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<Function>*>(object))(std::forward<Arguments>(arguments)...);
          }) {
        static_assert(!std::is_function_v<std::remove_reference_t<Function>>, "wrap a plain function in a lambda");
    }

    Result operator()(Arguments... arguments) const { return call_(object_, std::forward<Arguments>(arguments)...); }

private:
    void* object_;
    Result (*call_)(void* object, Arguments... arguments);
};

}  // namespace firma
