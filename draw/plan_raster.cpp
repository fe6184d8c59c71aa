// SPDX-License-Identifier: MIT
// What is nearest to the viewer in each small square of a plan: see the header.
#include "draw/plan_raster.h"

#include <algorithm>
#include <cmath>

namespace firma::draw {
namespace {

constexpr double kGrace = 0.05;    // metres that a polygon may lie behind what hides it
constexpr double kDrawnIn = 0.15;  // of the way to the middle

/// One face into the squares whose middles it covers.
class FacePainter {
public:
    FacePainter(const View& view, PlanRaster& raster, const std::optional<double>& cut)
        : view_(view), raster_(raster), most_(cut ? view.toward * *cut : INFINITY) {}

    void paint(const Face& face, std::uint32_t index) {
        if (!view_.sees(face.normal, face.two_sided)) return;
        double top = INFINITY, bottom = -INFINITY;
        outline_.clear();
        for (const Vec3& corner : face.corners) {
            const PagePoint p = view_.place(corner);
            outline_.push_back(
                {(p.x - raster_.corner.x) / PlanRaster::kCell, (p.y - raster_.corner.y) / PlanRaster::kCell});
            top = std::min(top, outline_.back().y);
            bottom = std::max(bottom, outline_.back().y);
        }
        for (int y = row_of(top); y < row_of(bottom); ++y) paint_row(face, index, y);
    }

private:
    int row_of(double y) const { return int(std::clamp(std::floor(y + 0.5), 0.0, double(raster_.height))); }
    int column_of(double x) const { return int(std::clamp(std::floor(x + 0.5), 0.0, double(raster_.width))); }

    void paint_row(const Face& face, std::uint32_t index, int y) {
        double low = INFINITY, high = -INFINITY;
        for (std::size_t k = 0; k < outline_.size(); ++k) {
            const PagePoint &a = outline_[k], &b = outline_[(k + 1) % outline_.size()];
            if ((a.y <= y + 0.5) == (b.y <= y + 0.5)) continue;
            const double x = a.x + (b.x - a.x) * ((y + 0.5 - a.y) / (b.y - a.y));
            low = std::min(low, x);
            high = std::max(high, x);
        }
        if (!(low < high)) return;
        for (int x = column_of(low); x < column_of(high); ++x) {
            const double nearness = nearness_at(face, raster_.middle(x, y));
            const std::size_t at = raster_.at(x, y);
            if (nearness > most_ || nearness <= raster_.nearness[at]) continue;
            raster_.nearness[at] = nearness;
            raster_.face[at] = index;
        }
    }

    /// Of the face's plane at a place of the page.
    double nearness_at(const Face& face, const PagePoint& p) const {
        const double across = view_.region.low[view_.across] + (p.x - view_.corner.x) / view_.scale;
        const double upward = view_.region.low[view_.upward] - (p.y - view_.corner.y) / view_.scale;
        const Vec3 &c = face.corners[0], &n = face.normal;
        return view_.toward * (c[view_.depth] - (n[view_.across] * (across - c[view_.across]) +
                                                 n[view_.upward] * (upward - c[view_.upward])) /
                                                    n[view_.depth]);
    }

    const View& view_;
    PlanRaster& raster_;
    const double most_;
    std::vector<PagePoint> outline_;  ///< in squares
};

}  // namespace

PlanRaster make_raster(const View& view, std::span<const Face> faces, const std::optional<double>& cut) {
    PlanRaster raster;
    raster.width = std::max(1, int(std::ceil(view.width() / PlanRaster::kCell)));
    raster.height = std::max(1, int(std::ceil(view.height() / PlanRaster::kCell)));
    raster.corner = {view.corner.x, view.corner.y - view.height()};
    const std::size_t cells = std::size_t(raster.width) * std::size_t(raster.height);
    raster.face.assign(cells, PlanRaster::kNothing);
    raster.nearness.assign(cells, -INFINITY);
    FacePainter painter(view, raster, cut);
    for (std::size_t k = 0; k < faces.size(); ++k) painter.paint(faces[k], std::uint32_t(k));
    return raster;
}

bool is_seen(const PlanRaster& raster, const View& view, std::span<const Vec3> polygon) {
    Vec3 middle;
    for (const Vec3& corner : polygon) middle = middle + corner * (1.0 / double(polygon.size()));
    const auto sees = [&](const Vec3& p) {
        const PagePoint at = view.place(p);
        const double x = std::floor((at.x - raster.corner.x) / PlanRaster::kCell);
        const double y = std::floor((at.y - raster.corner.y) / PlanRaster::kCell);
        if (!(x >= 0 && x < raster.width && y >= 0 && y < raster.height)) return false;
        return view.nearness(p) + kGrace >= raster.nearness[raster.at(int(x), int(y))];
    };
    if (sees(middle)) return true;
    return std::any_of(polygon.begin(), polygon.end(),
                       [&](const Vec3& corner) { return sees(corner + (middle - corner) * kDrawnIn); });
}

}  // namespace firma::draw
