// SPDX-License-Identifier: GPL-3.0-or-later
/// Walls, rooms and openings of one storey while it is being laid out.
#pragma once

#include "tests/simulator/axis_curve.h"
#include "tests/simulator/building_spec.h"
#include "tests/simulator/random.h"

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace s2b::sim
{

enum class RoomKind
{
    Office,
    Corridor,
    Wet,  ///< in front of WC cubicles
    Cubicle,
    Stair
};

/// A room: walls around it counter-clockwise, and the points where the axes of neighbouring walls meet.
struct Room
{
    RoomKind kind = RoomKind::Office;
    std::string name;
    std::vector<std::size_t> walls;        ///< indices into Building::walls
    std::vector<Eigen::Vector2d> joints;   ///< joints[i]: of walls[i] and walls[i + 1]
    std::vector<Eigen::Vector2d> outline;  ///< between wall faces, counter-clockwise
    std::size_t space = 0;                 ///< index into Building::spaces

    [[nodiscard]] Eigen::Vector2d middle() const;
    [[nodiscard]] bool contains(const Eigen::Vector2d& point) const;
    /// Distance to the outline, positive inside.
    [[nodiscard]] double clearance(const Eigen::Vector2d& point) const;
};

/// One storey being laid out: adds to the Building, keeps what is taken along each wall.
class StoreyPlan
{
public:
    StoreyPlan(Building& building, std::size_t storey, double clearHeight_m, std::uint32_t& nextId);

    /// A wall whose ends are joined later. @return its index in Building::walls.
    std::size_t addWall(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double bulge, double thickness_m,
                        bool isExternal);
    /// The wall's end lies on the other's path: its body ends at the other's face.
    void butt(std::size_t wall, JunctionEnd end, std::size_t other);
    /// Two ends meet: `through` reaches to the other's outer face, the other ends at the face of `through`.
    void corner(std::size_t through, JunctionEnd throughEnd, std::size_t other, JunctionEnd otherEnd);
    /// Where the axis of a wall, or its prolongation, meets another's.
    [[nodiscard]] Eigen::Vector2d crossing(std::size_t wall, std::size_t other, const Eigen::Vector2d& near) const;

    /// The polygon between wall faces: the sides towards the joints' middle, or the far ones. Counter-clockwise.
    [[nodiscard]] std::vector<Eigen::Vector2d> faceRing(const std::vector<std::size_t>& walls,
                                                        const std::vector<Eigen::Vector2d>& joints, bool inner) const;
    /// Finds the outline from the walls' faces and adds the Space. `joints` are the axis crossings.
    Room& addRoom(RoomKind kind, std::string name, std::vector<std::size_t> walls, std::vector<Eigen::Vector2d> joints,
                  double height_m);

    /// Nothing else may be put on this stretch of the wall.
    void take(std::size_t wall, double from, double to) { m_taken.push_back({wall, from, to}); }
    /// A free stretch of `width_m` on the part of `wall` that bounds `room`: its start s, or a negative number.
    /// @param position  in [0, 1]: where in the free range; < 0: drawn.
    [[nodiscard]] double freeStretch(std::size_t wall, const Room& room, double width_m, double margin_m,
                                     Random& random, double position = -1.0) const;
    /// @return null when there was no room for it.
    Opening* addOpening(std::size_t wall, const Room& room, OpeningKind kind, double width_m, double height_m,
                        double sill_m, Random& random, double position = -1.0);
    void addColumn(const Eigen::Vector2d& center, double yaw_rad, const Section& section);

    /// +1 when the room lies to the left of the wall.
    [[nodiscard]] double sideOf(std::size_t wall, const Room& room) const { return sideOf(wall, room.joints); }
    [[nodiscard]] double sideOf(std::size_t wall, const std::vector<Eigen::Vector2d>& joints) const;
    [[nodiscard]] const Wall& wall(std::size_t index) const { return m_building.walls[index]; }
    [[nodiscard]] double clearHeight() const { return m_clearHeight_m; }
    [[nodiscard]] std::size_t storeyIndex() const { return m_storey; }
    [[nodiscard]] const Building& building() const { return m_building; }
    std::deque<Room> rooms;  ///< references stay valid

private:
    struct Taken
    {
        std::size_t wall;
        double from;
        double to;
    };

    Building& m_building;
    std::size_t m_storey;
    double m_clearHeight_m;
    std::uint32_t& m_nextId;
    std::vector<Taken> m_taken;  ///< openings, and the footprints of walls that end on this one
};

}  // namespace s2b::sim
