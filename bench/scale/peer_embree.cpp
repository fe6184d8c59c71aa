// SPDX-License-Identifier: MIT
// Embree 3: single rays in robust mode, one thread.
#include <embree3/rtcore.h>

#include <cstdio>

#include "scale/scale_peer.h"

namespace firma::bench {
namespace {

class EmbreeScalePeer final : public ScalePeer {
public:
    EmbreeScalePeer() : device_(rtcNewDevice("threads=1,set_affinity=0")) {
        rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    }
    EmbreeScalePeer(const EmbreeScalePeer&) = delete;
    EmbreeScalePeer& operator=(const EmbreeScalePeer&) = delete;
    ~EmbreeScalePeer() override {
        if (scene_) rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    std::string describe() const override {
        const auto version = unsigned(rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_VERSION));
        char text[200];
        std::snprintf(text, sizeof text,
                      "Embree %u.%u.%u; rtcIntersect1, RTC_SCENE_FLAG_ROBUST, build quality medium (the default), one "
                      "thread, shared buffers; the instructions that it chooses here",
                      version / 10000, version / 100 % 100, version % 100);
        return text;
    }
    bool has(CastShape shape) const override { return shape == CastShape::kRay; }

    void build(const ScaleScene& scene) override {
        positions_ = scene.mesh.positions;
        positions_.push_back(0);  // it reads four floats a vertex
        corners_ = scene.mesh.corners;
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
        RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions_.data(), 0, 12,
                                   scene.mesh.positions.size() / 3);
        rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners_.data(), 0, 12,
                                   scene.mesh.triangles());
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene_, mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(scene_);
    }
    std::size_t own_bytes() const override {
        return std::size_t(bytes_) + positions_.size() * sizeof(float) + corners_.size() * sizeof(std::uint32_t);
    }

    void cast(CastShape, std::span<const FloatCast> casts, double* fractions) override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (std::size_t k = 0; k < casts.size(); ++k) {
            const FloatCast& c = casts[k];
            RTCRayHit ray{};
            ray.ray.org_x = c.start[0];
            ray.ray.org_y = c.start[1];
            ray.ray.org_z = c.start[2];
            ray.ray.dir_x = c.path[0];
            ray.ray.dir_y = c.path[1];
            ray.ray.dir_z = c.path[2];
            ray.ray.tfar = 1;
            ray.ray.mask = ~0u;
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &ray);
            fractions[k] = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kScaleMiss : double(ray.ray.tfar);
        }
    }

private:
    static bool count_bytes(void* self, ssize_t bytes, bool) {
        static_cast<EmbreeScalePeer*>(self)->bytes_ += bytes;
        return true;
    }

    RTCDevice device_;
    RTCScene scene_ = nullptr;
    std::vector<float> positions_;
    std::vector<std::uint32_t> corners_;
    ssize_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<ScalePeer> make_embree_peer() {
    return std::make_unique<EmbreeScalePeer>();
}

}  // namespace firma::bench
