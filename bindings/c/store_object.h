// SPDX-License-Identifier: MIT
// A history behind a handle.
#pragma once

#include <utility>

#include "bindings/c/handles.h"
#include "firma/versions.h"

namespace firma::c {

struct StoreObject final : Object {
    static constexpr Kind kKind = Kind::kStore;
    static constexpr const char* kNoun = "store";
    StoreObject(World first, const WorldStoreOptions& options) : store(std::move(first), options) {}
    WorldStore store;
};

}  // namespace firma::c
