// SPDX-License-Identifier: MIT
// Bodies, their shapes and contacts as bytes, and back.
#pragma once

#include <cstring>
#include <map>
#include <vector>

#include "firma/bodies.h"
#include "log/byte_reader.h"

namespace firma {

/// Shapes of bodies, each once: equal ones are one, whichever handles there are to them.
class ShapeNumbers {
public:
    std::uint32_t number(const BodyShape& shape);
    /// All of them, in order of their numbers.
    void put(ByteWriter& out) const;

private:
    /// The shorter first, else by the first byte that differs.
    struct InOrder {
        bool operator()(const std::vector<std::byte>& a, const std::vector<std::byte>& b) const {
            return a.size() != b.size() ? a.size() < b.size() : std::memcmp(a.data(), b.data(), a.size()) < 0;
        }
    };

    std::map<std::vector<std::byte>, std::uint32_t, InOrder> numbers_;
    std::vector<const std::vector<std::byte>*> in_order_;
};

void put_shape(ByteWriter& out, const BodyShape& shape);
/// @return not valid() where the reader has an error
BodyShape take_shape(ByteReader& in);

/// All but its shape and its use.
void put_body(ByteWriter& out, const Body& body);
void take_body(ByteReader& in, Body& body);

void put_bodies(ByteWriter& out, const Bodies& bodies);
/// Judged by fault_of_game().
Bodies take_bodies(ByteReader& in);

}  // namespace firma
