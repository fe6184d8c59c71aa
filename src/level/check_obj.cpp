// SPDX-License-Identifier: MIT
// Checks an .obj by the decimals it holds.
#include <string>

#include "level/check_mesh_core.h"
#include "level/message.h"
#include "level/parse_obj.h"

namespace firma {
namespace {

class ObjMeshMaker final : public ObjVisitor {
public:
    explicit ObjMeshMaker(std::string_view name) : name_(name) {}

    std::optional<Error> number(std::string_view word, std::size_t axis, std::uint32_t line) override {
        const auto exact = decimals_.add(word);
        if (!exact)
            return error_at_line(ErrorCode::kOutOfRange, name_, line,
                                 quote(word) + " has more than " + std::to_string(ExactDecimals::kMostDigits) +
                                     " digits or a larger exponent: too much to be checked exactly");
        position_[axis] = *exact;
        return std::nullopt;
    }

    bool vertex(const ObjVertex& vertex) override {
        const auto point = snap(vertex.metres);
        if (!point) return false;
        mesh_.exact.push_back(position_);
        mesh_.nearest.push_back(vertex.position);
        mesh_.snapped.push_back(*point);
        return true;
    }

    std::optional<Error> face(const ObjFace& face) override {
        const auto first = std::uint32_t(mesh_.corners.size());
        mesh_.corners.insert(mesh_.corners.end(), face.corners.begin(), face.corners.end());
        mesh_.faces.push_back({first, std::uint32_t(face.corners.size()), face.source, face.line});
        return std::nullopt;
    }

    MeshCheck check() {
        mesh_.long_digits = decimals_.take_long_digits();
        return check_exact_mesh(mesh_);
    }

private:
    std::string name_;
    ExactDecimals decimals_;
    std::array<ExactNumber, 3> position_;
    ExactMesh mesh_;
};

}  // namespace

Result<MeshCheck> check_obj(std::string_view text, std::string name, const ReadOptions& options) {
    ObjMeshMaker maker(name);
    const Result<ObjCounts> counts = parse_obj(text, name, options, maker);
    if (!counts) return counts.error();
    return maker.check();
}

}  // namespace firma
