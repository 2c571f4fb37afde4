// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/variety.h"

#include <cmath>

namespace s2b::sim
{

namespace
{

/// A small laser on a turntable: sparse between its lines, coarse in range, one set-up in a room or a few.
void drawLineLaser(Variety& v, Random& random)
{
    ScanSettings& scan = v.scan;
    scan.step_deg = scan.lineStep_deg = random.uniform(0.7, 1.4);
    if (random.chance(0.5))
        scan.step_deg = random.uniform(0.6, 1.2);
    else if (random.chance(0.7))
        scan.step_deg = random.uniform(0.15, 0.4);
    else
    {
        scan.step_deg = random.uniform(0.8, 2.0);
        scan.lineStep_deg = random.uniform(0.2, 0.5);
    }
    scan.noise_m = 0.001 * std::exp(random.uniform(std::log(3.0), std::log(30.0)));
    scan.rangeStep_m = random.chance(0.5) ? 0.01 : 0.0;
    scan.rangeMax_m = random.uniform(8.0, 30.0);
    scan.voxel_m = random.chance(0.7) ? 0.005 : random.uniform(0.02, 0.05);
    // It stands by eye, and its mirror is not where it should be.
    scan.tilt_deg = random.chance(0.7) ? random.uniform(0.0, 1.5) : 0.0;
    scan.warp_m = random.chance(0.6) ? random.uniform(0.0, 0.05) : 0.0;
    scan.mostStations = random.chance(0.65) ? 1 : 2 + static_cast<unsigned>(random.below(3));
    v.outside = false;
}

}  // namespace

Variety drawVariety(std::uint64_t seed)
{
    Random random{seed, 0x7a4};
    Variety v;
    BuildingSpec& spec = v.spec;
    spec.seed = seed;
    spec.varied = random.chance(0.9);
    const double kind = random.uniform();
    spec.layout = kind < 0.3 ? Layout::OneRoom : kind < 0.5 ? Layout::TwoRooms : Layout::Corridor;
    spec.storeys = random.chance(0.45) ? 2 : 1;
    spec.roomsPerSide = 2 + static_cast<int>(random.below(2));
    if (spec.layout == Layout::Corridor)
    {
        spec.roomWidth_m = {2.6, random.uniform(3.5, 6.0)};
        spec.roomDepth_m = {4.0, random.uniform(4.2, 6.0)};
        spec.corridorWidth_m = {1.4, random.uniform(1.5, 4.0)};
    }
    else
    {
        const bool isHall = spec.layout == Layout::OneRoom && random.chance(0.6);
        const double size = isHall ? random.uniform(8.0, 18.0) : random.uniform(3.0, 7.0);
        spec.roomWidth_m = {size, size * 1.2};
        spec.roomDepth_m = {0.6 * size, size};
    }
    const double height = random.chance(0.7) ? random.uniform(2.25, 3.0) : random.uniform(3.0, 4.5);
    spec.clearHeight_m = {height, height};
    spec.slabThickness_m = {0.15, 0.45};
    spec.exteriorThickness_m = {random.uniform(0.15, 0.55)};
    const double partition = random.uniform(0.06, 0.25);
    spec.partitionThickness_m = {partition, partition, random.uniform(0.06, 0.3)};
    spec.openDoors = random.uniform(0.1, 0.6);
    spec.removedDoors = random.uniform(0.0, 0.3);
    spec.cubicles = random.chance(0.15);
    spec.obliqueWalls = random.chance(0.25);
    spec.curvedWalls = random.chance(0.12);
    spec.rectangularColumns = random.chance(0.4);
    spec.roundColumns = random.chance(0.4);
    spec.engagedColumns = random.chance(0.4);
    spec.suspendedCeilings = random.chance(0.35);
    spec.stairs = spec.layout == Layout::Corridor && random.chance(0.7);
    spec.facadeAngle_deg = random.chance(0.15) ? random.uniform(-15.0, 15.0) : 0.0;
    spec.furniture = random.chance(0.75);
    spec.groundLevel_m = -random.uniform(0.05, 0.6);
    spec.yaw_deg = random.uniform(-45.0, 45.0);
    spec.pitchedRoof = spec.varied && random.chance(0.5);

    ScanSettings& scan = v.scan;
    scan.seed = seed;
    scan.step_deg = random.uniform(0.22, 0.4);
    scan.noise_m = 0.001 * std::exp(random.uniform(0.0, std::log(10.0)));
    scan.noise_m = random.chance(0.6) ? 0.0025 : scan.noise_m;
    scan.mixedPixels = random.uniform(0.1, 0.35);
    scan.glassReturn = random.uniform(0.02, 0.15);
    scan.voxel_m = random.chance(0.8) ? random.uniform(0.018, 0.032) : random.uniform(0.03, 0.05);
    v.outside = random.chance(0.35);

    // Draws of their own, so that the buildings above stay what they are.
    Random scanner{seed, 0x7a5};
    const double glass = scanner.uniform();
    if (glass < 0.1)
        scan.glassReturn = 0.0;
    else if (glass < 0.22)
        scan.glassReturn = scanner.uniform(0.25, 0.8);
    const double make = scanner.uniform();
    if (make < 0.22)
        drawLineLaser(v, scanner);
    else if (make < 0.28)
        scan.voxel_m = scanner.uniform(0.05, 0.1);  // thinned to what an office's network carries
    return v;
}

}  // namespace s2b::sim
