// SPDX-License-Identifier: MIT
// Film strips of a fire fight: copies of the game at some times, drawn side by side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/fight_game.h"
#include "draw/draw_scene.h"

namespace firma::cli {

/// One strip: from where, and when.
struct FightFilm {
    std::string name;  ///< of the file, without its ending
    std::vector<double> seconds;
    std::optional<draw::Camera> camera;  ///< nothing: chosen so that craters are seen
    std::optional<Vec3> lamp;            ///< nothing: above the camera
};

/// The strips of the depot's fire fight, and of another level's of so many seconds.
std::vector<FightFilm> depot_films();
std::vector<FightFilm> roaming_films(double seconds);

/// Keeps copies of a game as it goes on.
class FightCamera {
public:
    explicit FightCamera(std::vector<FightFilm> films) : films_(std::move(films)) { frames_.resize(films_.size()); }

    /// After each frame.
    void look(const FightGame& game);
    /// Draws what it saw.
    /// @param folder  it is there
    /// @return the files' names; none of a strip of which nothing was seen, or for which no camera was found
    std::vector<std::string> develop(const std::string& folder) const;

private:
    std::vector<FightFilm> films_;
    std::vector<std::vector<FightGame>> frames_;  ///< of each
};

}  // namespace firma::cli
