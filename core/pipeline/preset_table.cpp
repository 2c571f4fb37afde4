// SPDX-License-Identifier: GPL-3.0-or-later
/// The rows of the presets. A preset says only what differs from the defaults; a test proves that every row does, that
/// its value is in range, and that it has a reason.
// clang-format off
#include "core/pipeline/presets.h"

namespace s2b
{

const std::vector<Preset>& presetTable()
{
    static const std::vector<Preset> kTable = {
        {"residential", "Residential", "Flats and houses: thin partitions, thick outer walls, few and slender columns.", PresetKind::Building, {
            {"walls.defaultThickness", 0.12, "a plastered partition of 11.5 cm, or a boarded stud wall of 10 to 12.5 cm"},
            {"walls.defaultExternalThickness", 0.36, "36.5 cm of masonry, or 24 cm with its insulation"},
            {"walls.maximumThickness", 0.7, "the outer walls of old houses reach 64 cm and their plaster"},
            {"openings.maximumDoorWidth", 3.0, "the widest common door is that of a garage for one car; wider openings join two rooms"},
            {"columns.maximumSize", 0.6, "posts and piers; a larger block in a flat is a chimney, a shaft or a wardrobe"},
        }},
        {"office", "Office", "Offices, schools, hospitals: stud partitions, suspended ceilings, a grid of columns.", PresetKind::Building, {
            {"levels.minimumRoomHeight", 2.1, "rooms keep 2.5 m below suspended ceilings; cabinets end at 2 m"},
            {"walls.defaultThickness", 0.125, "a metal stud partition: studs of 7.5 or 10 cm with a board on each side"},
            {"walls.defaultExternalThickness", 0.35, "20 cm of concrete with insulation and cladding"},
            {"openings.minimumDoorWidth", 0.6, "leaves begin at 0.7 m; narrower holes are niches and hatches"},
            {"openings.maximumDoorWidth", 2.6, "a double leaf door with a side light; wider openings are passages"},
            {"columns.maximumSize", 1.2, "columns of tall buildings' lower storeys"},
        }},
        {"hall", "Hall", "Industrial and sports halls, warehouses: one high room, panels, gates.", PresetKind::Building, {
            {"levels.minimumRoomHeight", 2.3, "rooms built into a hall have 2.5 m; platforms and machines are lower"},
            {"levels.maximumRoomHeight", 20.0, "below the trusses of a high-bay warehouse"},
            {"levels.minimumArea", 20.0, "the top of a machine or of a rack is not a floor"},
            {"walls.defaultExternalThickness", 0.2, "sandwich panels of 12 to 20 cm, or precast concrete"},
            {"walls.minimumFreeLength", 1.2, "sides of machines and racks stand free, walls meet other walls"},
            {"openings.maximumDoorWidth", 8.0, "gates for lorries are 3 to 5 m wide, sliding gates up to 8 m"},
        }},
        {"mobile-mapping", "Mobile mapping", "Handheld, backpack and trolley systems: noise of a centimetre or two, and passes that lie some centimetres apart.", PresetKind::Survey, {
            {"cells.size", 0.03, "a cell as large as the noise has no stable normal"},
            {"walls.normalTolerance", 0.15, "normals of noisy cells scatter more"},
            {"walls.planeDistance", 0.04, "two to three times the noise, and the drift between two passes"},
            {"walls.minimumThickness", 0.07, "two passes along one face, some centimetres apart, are not a wall"},
            {"walls.minimumFaceArea", 0.25, "small faces are made of noise more often"},
            {"walls.mergeOffset", 0.06, "drift shifts the pieces of one wall sideways"},
            {"columns.circleTolerance", 0.025, "the noise of the points on a round column"},
        }},
    };
    return kTable;
}

}  // namespace s2b
