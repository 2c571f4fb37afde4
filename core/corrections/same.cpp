// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/corrections/same.h"

#include <tuple>

namespace s2b
{
namespace
{

auto values(const Dimension& d)
{
    return std::tie(d.value_m, d.provenance, d.rms_m);
}
auto values(const Evidence& e)
{
    return std::tie(e.points, e.faceCoverage, e.facesSeen, e.rms_m, e.labelShare);
}
auto values(const Polygon& p)
{
    return std::tie(p.outer, p.holes);
}
}  // namespace

bool isSame(const Storey& a, const Storey& b)
{
    const auto all = [](const Storey& s)
    { return std::tuple_cat(std::tie(s.id, s.name, s.elevation_m), values(s.height)); };
    return all(a) == all(b);
}

bool isSame(const Wall& a, const Wall& b)
{
    const auto all = [](const Wall& w)
    {
        return std::tuple_cat(std::tie(w.id, w.storey, w.start, w.end, w.bulge, w.bodyStart_m, w.bodyEnd_m, w.base_m,
                                       w.topProfile, w.isExternal, w.isExternalKnown),
                              values(w.height), values(w.thickness), values(w.evidence));
    };
    return all(a) == all(b);
}

bool isSame(const Opening& a, const Opening& b)
{
    const auto all = [](const Opening& o)
    {
        return std::tuple_cat(
            std::tie(o.id, o.host, o.kind, o.offset_m, o.leaves, o.leafState, o.hingeAtStart, o.opensToLeft),
            values(o.width), values(o.height), values(o.sill), values(o.evidence));
    };
    return all(a) == all(b);
}

bool isSame(const Column& a, const Column& b)
{
    const auto all = [](const Column& c)
    {
        return std::tuple_cat(std::tie(c.id, c.storey, c.center, c.yaw_rad, c.base_m, c.sectionProvenance),
                              values(c.height), values(c.evidence));
    };
    return all(a) == all(b) && a.section == b.section;
}

bool isSame(const Slab& a, const Slab& b)
{
    const auto all = [](const Slab& s)
    {
        return std::tuple_cat(std::tie(s.id, s.storey, s.kind, s.top_m), values(s.outline), values(s.thickness),
                              values(s.evidence));
    };
    return all(a) == all(b);
}

bool isSame(const Space& a, const Space& b)
{
    const auto all = [](const Space& s)
    {
        return std::tuple_cat(std::tie(s.id, s.storey, s.name, s.floor_m, s.area_m2, s.boundedBy), values(s.outline),
                              values(s.height));
    };
    return all(a) == all(b);
}

bool isSame(const Junction& a, const Junction& b)
{
    return std::tie(a.wallA, a.wallB, a.endA, a.endB) == std::tie(b.wallA, b.wallB, b.endA, b.endB);
}

bool isSame(const Diagnostic& a, const Diagnostic& b)
{
    const auto all = [](const Diagnostic& d)
    { return std::tie(d.severity, d.stage, d.code, d.text, d.element, d.location); };
    return all(a) == all(b);
}

}  // namespace s2b
