// SPDX-License-Identifier: GPL-3.0-or-later
/// The rows of the parameter table. A test compares them with the members of the structs: a member without a row, a
/// row with another name than its member's, and a default outside its range are all found.
///
/// Sources: "D3.6, n" when the section gives the value; "D3.6, n; value: practice" when it gives the parameter but no
/// value; "practice" for a value from the dimensions that buildings and surveys commonly have; "measured: ..." when it
/// was chosen by an experiment.
// clang-format off
#include "core/pipeline/parameters.h"

namespace s2b
{

namespace
{

/// One row for a member of one stage's struct.
template <auto kStage, auto kMember>
ParameterInfo row(const char* name, const char* unit, double minimum, double maximum, const char* help, const char* source)
{
    return {name, unit, minimum, maximum, help, source, +[](Parameters& p) { return &((p.*kStage).*kMember); }};
}

}  // namespace

const std::vector<ParameterInfo>& parameterTable()
{
    using P = Parameters;
    static const std::vector<ParameterInfo> kTable = {
        row<&P::clutter, &ClutterParams::enabled>("clutter.enabled", "", 0, 1, "Whether sparse surroundings are removed first.", "D3.6, 3.2"),
        row<&P::clutter, &ClutterParams::voxelSize_m>("clutter.voxelSize", "m", 0.1, 5, "Edge of the voxels whose points are counted.", "D3.6, 3.2"),
        row<&P::clutter, &ClutterParams::minimumDensity>("clutter.minimumDensity", "1", 0, 1, "Voxels with a smaller share of the cloud's typical number of points are clutter.", "D3.6, 3.2 (2500 points of one cloud, made relative); value: practice"),
        row<&P::clutter, &ClutterParams::margin_m>("clutter.margin", "m", 0, 10, "Kept around the box of the dense voxels.", "practice: most of a voxel, so that the outermost faces stay whole"),

        row<&P::cells, &CellParams::size_m>("cells.size", "m", 0.005, 0.2, "Edge of a surface cell in a dense cloud; a sparser cloud gets larger cells.", "practice: below half of the thinnest wall"),
        row<&P::cells, &CellParams::spacingsPerCell>("cells.spacingsPerCell", "1", 0.5, 10, "Smallest cell edge in units of the cloud's point spacing.", "practice: 27 cells then hold about 9 points of a surface"),
        row<&P::cells, &CellParams::minimumNeighbours>("cells.minimumNeighbours", "1", 3, 100, "Points that a neighbourhood needs for a normal.", "practice: twice the three that define a plane"),

        row<&P::frame, &FrameParams::verticalTolerance>("frame.verticalTolerance", "1", 0.001, 0.7, "Largest |z| of the unit normal of a vertical surface.", "practice: about 9 degrees"),

        row<&P::levels, &LevelParams::binSize_m>("levels.binSize", "m", 0.005, 0.2, "Bin of the height histogram.", "D3.6, 3.3; value: practice, a surface cell"),
        row<&P::levels, &LevelParams::minimumRoomHeight_m>("levels.minimumRoomHeight", "m", 0.5, 10, "A ceiling is at least so far above its floor.", "D3.6, 3.3; value: practice, below the lowest usable room"),
        row<&P::levels, &LevelParams::maximumRoomHeight_m>("levels.maximumRoomHeight", "m", 1, 50, "A ceiling is at most so far above its floor.", "D3.6, 3.3; value: practice"),
        row<&P::levels, &LevelParams::minimumArea_m2>("levels.minimumArea", "m2", 0.1, 10000, "Smallest horizontal surface that makes a level.", "practice: a small room"),
        row<&P::levels, &LevelParams::minimumAreaShare>("levels.minimumAreaShare", "1", 0, 1, "Smallest surface that makes a level, as a share of the largest level's.", "practice: more than tables and shelves of one height cover"),

        row<&P::walls, &WallParams::normalTolerance>("walls.normalTolerance", "1", 0.001, 0.5, "Largest 1 - |n.a| of a normal n that belongs to the direction a.", "D3.6, 3.4.1"),
        row<&P::walls, &WallParams::clusterRadius_m>("walls.clusterRadius", "m", 0.01, 1, "DBSCAN radius of wall instances.", "D3.6, 3.4.2; value: practice, below the narrowest passage"),
        row<&P::walls, &WallParams::clusterMinimumCells>("walls.clusterMinimumCells", "1", 1, 1000, "Cells within the radius that make a cell a core of an instance.", "D3.6, 3.4.2; value: practice"),
        row<&P::walls, &WallParams::planeDistance_m>("walls.planeDistance", "m", 0.002, 0.2, "Largest distance of a cell from its plane.", "D3.6, 3.4.3; value: practice, several times a scanner's noise"),
        row<&P::walls, &WallParams::minimumFaceArea_m2>("walls.minimumFaceArea", "m2", 0.01, 10, "Smallest face that counts.", "D3.6, 3.4.3 (minimum support, made an area); value: practice"),
        row<&P::walls, &WallParams::minimumThickness_m>("walls.minimumThickness", "m", 0.01, 1, "Parallel faces nearer than this are not two faces of a wall.", "practice: the thinnest partitions"),
        row<&P::walls, &WallParams::maximumThickness_m>("walls.maximumThickness", "m", 0.05, 3, "Parallel faces farther apart than this are not two faces of one wall.", "D3.6, 3.4.3; value: practice"),
        row<&P::walls, &WallParams::defaultThickness_m>("walls.defaultThickness", "m", 0.01, 3, "Assumed thickness of a wall with one face seen.", "practice: a common interior wall"),
        row<&P::walls, &WallParams::defaultExternalThickness_m>("walls.defaultExternalThickness", "m", 0.01, 3, "Assumed thickness of an external wall with one face seen.", "practice: a common external wall"),
        row<&P::walls, &WallParams::minimumLength_m>("walls.minimumLength", "m", 0.05, 10, "Shorter walls are dropped.", "D3.6, 6.2 (dimension threshold); value: practice"),
        row<&P::walls, &WallParams::minimumFreeLength_m>("walls.minimumFreeLength", "m", 0, 10, "Shorter walls that meet no other are dropped: columns and furniture.", "practice: the largest common column"),
        row<&P::walls, &WallParams::minimumCoverage>("walls.minimumCoverage", "1", 0, 1, "Smallest share of a wall's better seen side that shows a surface.", "measured: planes of stray points reach 0.17, walls of the simulated surveys begin at 0.28"),
        row<&P::walls, &WallParams::minimumHeight_m>("walls.minimumHeight", "m", 0.1, 10, "Lower walls are dropped.", "D3.6, 6.2 (dimension threshold); value: practice, a parapet stays"),
        row<&P::walls, &WallParams::mergeGap_m>("walls.mergeGap", "m", 0, 5, "Largest gap between collinear pieces of one wall.", "D3.6, 3.4.4 and 6.2 (merging); value: practice"),
        row<&P::walls, &WallParams::mergeUnseen_m>("walls.mergeUnseen", "m", 0, 20, "Largest hidden gap that collinear pieces are joined across, each longer than it.", "practice: a cupboard or a stair in front of a wall"),
        row<&P::walls, &WallParams::mergeOffset_m>("walls.mergeOffset", "m", 0, 0.5, "Largest sideways offset between collinear pieces of one wall.", "D3.6, 3.4.4 and 6.2 (merging); value: practice"),
        row<&P::walls, &WallParams::closeGap_m>("walls.closeGap", "m", 0, 5, "Largest gap that is closed at a corner.", "D3.6, 3.4.4 and 6.2 (closing); value: practice"),
        row<&P::walls, &WallParams::minimumTopStep_m>("walls.minimumTopStep", "m", 0.1, 5, "Smallest step of a wall's top that makes it two walls.", "D3.6, 6.2 (height correction); value: practice, a low lintel stays one wall"),
        row<&P::walls, &WallParams::widestOpening_m>("walls.widestOpening", "m", 0.5, 20, "Widest opening that a wall goes on above; what hangs above a wider one is a beam.", "practice: above a double door (DIN 18100: 2.0 m)"),
        row<&P::walls, &WallParams::deepestBeam_m>("walls.deepestBeam", "m", 0.1, 5, "What hangs from the ceiling above a wide opening and is no higher is a beam, not a wall.", "practice: above the deepest common downstand beam"),
        row<&P::walls, &WallParams::minimumAgreement>("walls.minimumAgreement", "1", 0.5, 1, "Smallest share of a face's cells that were scanned from one side, to be that side's (with known stations).", "practice: the rest is what was seen through and around it"),
        row<&P::walls, &WallParams::curved>("walls.curved", "", 0, 1, "Whether curved walls are looked for; if not, all walls are straight.", "practice"),
        row<&P::walls, &WallParams::minimumArcRadius_m>("walls.minimumArcRadius", "m", 0.3, 100, "Smallest radius of a curved wall's face.", "practice: above the thickest round column"),
        row<&P::walls, &WallParams::maximumArcRadius_m>("walls.maximumArcRadius", "m", 1, 100, "Largest radius of a curved wall's face.", "practice: a wall 5 m long still bends by 0.1 m"),

        row<&P::openings, &OpeningParams::clusterRadius_m>("openings.clusterRadius", "m", 0.01, 1, "DBSCAN radius of door instances.", "D3.6, 3.5; value: practice"),
        row<&P::openings, &OpeningParams::minimumDoorWidth_m>("openings.minimumDoorWidth", "m", 0.2, 5, "Narrower openings are no doors.", "practice: below the narrowest common leaf (DIN 18101: 0.61 m)"),
        row<&P::openings, &OpeningParams::maximumDoorWidth_m>("openings.maximumDoorWidth", "m", 0.5, 20, "Wider openings are no doors.", "practice: above a double garage door's leaf pair"),
        row<&P::openings, &OpeningParams::minimumDoorHeight_m>("openings.minimumDoorHeight", "m", 0.5, 5, "Lower openings are no doors.", "practice: below the lowest common door (DIN 18101: 1.985 m), seen above a step or rubble"),
        row<&P::openings, &OpeningParams::minimumWindowWidth_m>("openings.minimumWindowWidth", "m", 0.05, 5, "Narrower openings are no windows.", "practice"),
        row<&P::openings, &OpeningParams::maximumWindowWidth_m>("openings.maximumWindowWidth", "m", 0.5, 50, "Wider recesses are no windows; labelled ones may be wider.", "practice: a glazed front along a room; what is wider is a passage or a hidden wall"),
        row<&P::openings, &OpeningParams::minimumWindowHeight_m>("openings.minimumWindowHeight", "m", 0.05, 5, "Lower openings are no windows.", "practice"),
        row<&P::openings, &OpeningParams::minimumEmptyDoorWidth_m>("openings.minimumEmptyDoorWidth", "m", 0.2, 5, "Narrowest hole without leaf and frame that counts as a door.", "DIN 18100: structural openings from 0.625 m, less what a lining takes"),
        row<&P::openings, &OpeningParams::maximumEmptyDoorWidth_m>("openings.maximumEmptyDoorWidth", "m", 0.2, 10, "Widest hole without leaf and frame that counts as a door; a wider one is a plain opening.", "DIN 18100: openings for one leaf up to 1.25 m, and 0.1 m of tolerance"),
        row<&P::openings, &OpeningParams::minimumEmptyDoorHeight_m>("openings.minimumEmptyDoorHeight", "m", 0.5, 5, "Lowest hole without leaf and frame that counts as a door.", "DIN 18100: openings from 2.0 m, less floor covering and lining"),
        row<&P::openings, &OpeningParams::maximumEmptyDoorHeight_m>("openings.maximumEmptyDoorHeight", "m", 0.5, 10, "Highest hole without leaf and frame that counts as a door.", "DIN 18100: openings up to 2.25 m, and 0.2 m of tolerance"),
        row<&P::openings, &OpeningParams::leafReach_m>("openings.leafReach", "m", 0.3, 5, "How far beside a wall an open leaf is looked for.", "D3.6, 3.5 (enlarged box); value: the widest common leaf (DIN 18101: 1.235 m)"),
        row<&P::openings, &OpeningParams::minimumSeenThrough>("openings.minimumSeenThrough", "1", 0.05, 1, "Smallest share of a hole that rays of known stations passed, to be open by that alone.", "practice: half"),

        row<&P::columns, &ColumnParams::clusterRadius_m>("columns.clusterRadius", "m", 0.01, 1, "DBSCAN radius of column instances.", "D3.6, 3.6; value: practice, below the distance of two columns"),
        row<&P::columns, &ColumnParams::clusterMinimumCells>("columns.clusterMinimumCells", "1", 1, 100000, "Smaller clusters are artefacts.", "D3.6, 3.6 (100 to 5000 points), made a number of surface cells; value: practice"),
        row<&P::columns, &ColumnParams::sliceMargin_m>("columns.sliceMargin", "m", 0, 2, "Cut off above the floor and below the ceiling before the section is fitted.", "D3.6, 3.6; value: practice"),
        row<&P::columns, &ColumnParams::minimumSize_m>("columns.minimumSize", "m", 0.02, 2, "Smallest side or diameter of a column.", "practice: a slender steel post"),
        row<&P::columns, &ColumnParams::maximumSize_m>("columns.maximumSize", "m", 0.1, 10, "Largest side or diameter of a column.", "practice"),
        row<&P::columns, &ColumnParams::circleTolerance_m>("columns.circleTolerance", "m", 0.001, 0.2, "Largest RMS of a circle's fit to a round column.", "practice: several times a scanner's noise, below a square's 6 % of its side"),
        row<&P::columns, &ColumnParams::circleTrials>("columns.circleTrials", "1", 1, 100000, "RANSAC trials of a circle.", "D3.6, 3.6; value: practice, with half of the points outliers all trials miss once in 4e11"),
        row<&P::columns, &ColumnParams::profiles>("columns.profiles", "", 0, 1, "Whether I, L, U and T sections are looked for; if not, they are given as the box around them.", "practice"),
        row<&P::columns, &ColumnParams::profileTolerance_m>("columns.profileTolerance", "m", 0.001, 0.1, "Largest RMS of the points about the outline of an I, L, U or T section.", "practice: several times a scanner's noise"),

        row<&P::slabs, &SlabParams::defaultThickness_m>("slabs.defaultThickness", "m", 0.01, 2, "Assumed thickness of a slab of which one side was seen.", "practice: a common concrete slab"),
        row<&P::slabs, &SlabParams::minimumThickness_m>("slabs.minimumThickness", "m", 0.01, 1, "A ceiling nearer than this below a floor is not the slab's underside.", "practice: below the thinnest floor"),
        row<&P::slabs, &SlabParams::maximumThickness_m>("slabs.maximumThickness", "m", 0.05, 3, "A ceiling farther than this below a floor is not the slab's underside: it is suspended.", "practice: a joist floor with its ceiling"),
        row<&P::slabs, &SlabParams::minimumArea_m2>("slabs.minimumArea", "m2", 0.1, 1000, "Smaller slabs are dropped.", "practice: a small room"),
        row<&P::slabs, &SlabParams::minimumHoleArea_m2>("slabs.minimumHoleArea", "m2", 0.1, 100, "Smaller holes are closed.", "practice: below a steep stair's hole"),
        row<&P::slabs, &SlabParams::minimumHoleWidth_m>("slabs.minimumHoleWidth", "m", 0.1, 5, "Narrower holes are closed.", "practice: the narrowest stair"),
        row<&P::slabs, &SlabParams::outlineStep_m>("slabs.outlineStep", "m", 0, 1, "Smaller steps of a slab's outline are straightened.", "practice: above the error of an assumed wall thickness' parts, below a real recess"),

        row<&P::spaces, &SpaceParams::closeGap_m>("spaces.closeGap", "m", 0, 1, "Gaps between walls up to this wide are closed.", "practice: twice the error of an end that was not seen, below the narrowest passage"),
        row<&P::spaces, &SpaceParams::minimumWallHeight_m>("spaces.minimumWallHeight", "m", 0.1, 10, "Lower walls do not divide rooms.", "practice: eye level"),
        row<&P::spaces, &SpaceParams::minimumArea_m2>("spaces.minimumArea", "m2", 0.1, 100, "Smaller rooms are no spaces.", "practice: a cupboard that one can step into"),
        row<&P::spaces, &SpaceParams::minimumSeen>("spaces.minimumSeen", "1", 0, 1, "Smallest share of a room whose floor or ceiling was seen.", "practice: what is seen of a furnished room"),
        row<&P::spaces, &SpaceParams::minimumWallShare>("spaces.minimumWallShare", "1", 0, 1, "Smallest share of a room's outline that walls make up, where they leave it open.", "practice: half"),
    };
    return kTable;
}

}  // namespace s2b
