// SPDX-License-Identifier: MIT
// Our own bodies.
#include "bodies/body_peer.h"

namespace firma::bench {
namespace {

class FirmaBodies final : public BodyPeer {
public:
    std::string name() const override { return "Firma"; }
    std::string describe() const override { return "Firma: step() of a sixtieth of a second, its defaults"; }
    void start(const BodyScene& scene) override {
        world_ = scene.world;
        bodies_ = {};
        for (const Body& body : scene.bodies) add_body(bodies_, body);
    }
    void step() override { firma::step(bodies_, world_, 1.0 / 60); }
    void read(std::vector<Body>& bodies) const override { bodies = bodies_.slots; }

private:
    World world_;
    Bodies bodies_;
};

}  // namespace

std::unique_ptr<BodyPeer> make_firma_bodies() {
    return std::make_unique<FirmaBodies>();
}

}  // namespace firma::bench
