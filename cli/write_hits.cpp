// SPDX-License-Identifier: MIT
// Rows are appended to one string a chunk: that is what makes a million of them quick.
#include "cli/write_hits.h"

#include <optional>

#include "cli/numbers.h"
#include "firma/rooms.h"

namespace firma::cli {

namespace {

void append_point(std::string& out, const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        append_17(out, point[axis]);
        out += ',';
    }
}

}  // namespace

std::string_view status_name(Status status) {
    switch (status) {
        case Status::kMiss:
            return "miss";
        case Status::kHit:
            return "hit";
        case Status::kInitialOverlap:
            return "touching";
        case Status::kInvalid:
            return "invalid";
    }
    return "";
}

std::string_view feature_name(Feature feature) {
    switch (feature) {
        case Feature::kFace:
            return "face";
        case Feature::kEdge:
            return "edge";
        case Feature::kVertex:
            return "vertex";
    }
    return "";
}

void append_hit(std::string& out, std::size_t query, const World& world, const Hit& hit) {
    out += std::to_string(query);
    out += ',';
    out += status_name(hit.status);
    if (!hit.touched()) {
        out += ",,,,,,,,,,,,,,,,,\n";  // one comma for each of the 17 columns behind
        return;
    }
    out += ',';
    append_17(out, hit.fraction);
    out += ',';
    append_17(out, hit.safe_fraction);
    out += ',';
    append_point(out, hit.centre);
    append_point(out, hit.point);
    append_point(out, hit.normal);
    append_point(out, hit.face_normal);
    const std::optional<FaceInfo> face = world.face_info(hit.face);
    out += std::to_string(face ? face->source : 0);
    out += ',';
    out += feature_name(hit.feature);
    out += ',';
    out += std::to_string(face ? face->room.value : room_of(world, hit).value);
    out += '\n';
}

}  // namespace firma::cli
