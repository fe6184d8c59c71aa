// SPDX-License-Identifier: MIT
// The program of docs/projectiles.md: what a line goes through, and a thousand bullets.
#include <cstdio>
#include <vector>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::BrushLevel> level = firma::read_brush_level("levels/depot.map");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::World world = firma::make_world(level.value()).value();
    // Through what does a straight line go?
    firma::Piercing found;
    if (pierce(world, {{1, 0, 2}, {40, 3, 1}}, found) == firma::Status::kInvalid) return 1;
    for (const firma::PierceSpan& span : found.spans) {
        std::printf("%s of %.3f m:", span.pane ? "a pane" : "solid", span.thickness);
        for (std::uint32_t k = 0; k < span.matter_count; ++k) {
            const firma::MatterLength& part = found.matters[span.first_matter + k];
            std::printf(" %.3f m of '%s'", part.length, matter(world, part.matter).name.c_str());
        }
        std::puts("");
    }
    // A thousand bullets: what each matter does to them.
    const firma::MatterTable& table = matters_of(world);
    std::vector<firma::ShotTerms> terms(table.matters.size(), {.resistance = 1500});  // joules a metre
    if (const auto wood = matter_named(table, "wood")) terms[*wood] = {.resistance = 600};
    firma::FlyOptions options;
    options.matters = terms;
    std::vector<firma::Projectile> shots(1000);
    for (std::size_t k = 0; k < shots.size(); ++k) {
        shots[k].position = {1, double(k) * 0.01 - 5, 2};
        shots[k].velocity = {700, 0, 20};
        shots[k].mass = 0.008;
    }
    firma::ShotEvents events;
    int entered = 0, left = 0, stopped = 0;
    for (int step = 0; step < 60; ++step) {
        if (!fly(shots, world, 1.0 / 60, events, options)) return 1;
        for (const firma::ShotEvent& event : events.events) {
            entered += event.kind == firma::ShotEventKind::kEntered;
            stopped += event.kind == firma::ShotEventKind::kStopped;
            if (event.kind != firma::ShotEventKind::kLeft || left++ > 0) continue;
            std::printf("%u came out of %.2f m at %.0f m/s\n", event.projectile, event.thickness,
                        length(event.velocity));
        }
    }
    std::printf("entered: %d, left: %d, stopped: %d\n", entered, left, stopped);
}
