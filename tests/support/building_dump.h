// SPDX-License-Identifier: GPL-3.0-or-later
/// All of a Building as text, to the last bit: two of them are the same when their dumps are.
#pragma once

#include "core/model/building.h"

#include <format>
#include <string>

namespace s2b::test
{

class BuildingDump
{
public:
    explicit BuildingDump(const Building& b)
    {
        add(b.frame.origin.x(), b.frame.origin.y(), b.frame.origin.z(), b.frame.yaw_rad);
        for (const Storey& s : b.storeys)
            line("storey", s.id), m_text += s.name, add(s.elevation_m), add(s.height);
        for (const Wall& w : b.walls)
        {
            line("wall", w.id), add(w.storey.value), add(w.start), add(w.end),
                add(w.bulge, w.bodyStart_m, w.bodyEnd_m, w.base_m);
            add(w.height), add(w.thickness), add(w.isExternal), add(w.isExternalKnown), add(w.evidence);
            for (const Eigen::Vector2d& p : w.topProfile)
                add(p);
        }
        for (const Opening& o : b.openings)
        {
            line("opening", o.id), add(o.host.value), add(static_cast<int>(o.kind)), add(o.offset_m), add(o.width),
                add(o.height), add(o.sill);
            add(o.leaves, static_cast<int>(o.leafState), o.hingeAtStart, o.opensToLeft), add(o.evidence);
        }
        for (const Column& c : b.columns)
        {
            line("column", c.id), add(c.storey.value), add(c.center), add(c.yaw_rad, c.base_m), add(c.height),
                add(c.evidence);
            add(boxOf(c.section));
            if (const auto* p = std::get_if<ProfileSection>(&c.section))
                m_text += shapeName(p->shape), add(p->web_m, p->flange_m);
        }
        for (const Slab& s : b.slabs)
            line("slab", s.id), add(s.storey.value), add(static_cast<int>(s.kind)), add(s.outline), add(s.top_m),
                add(s.thickness), add(s.evidence);
        for (const Space& s : b.spaces)
        {
            line("space", s.id), m_text += s.name, add(s.storey.value), add(s.outline), add(s.floor_m, s.area_m2),
                add(s.height);
            for (const ElementId id : s.boundedBy)
                add(id.value);
        }
        for (const Junction& j : b.junctions)
            line("junction", j.wallA), add(j.wallB.value, static_cast<int>(j.endA), static_cast<int>(j.endB));
        for (const Diagnostic& d : b.diagnostics)
            line("diagnostic", d.element), m_text += d.stage + " " + d.code + " " + d.text,
                add(d.location.x(), d.location.y(), d.location.z());
    }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    void line(const char* what, ElementId id) { m_text += std::format("\n{} {}", what, id.value); }
    void value(double v) { m_text += std::format(" {:a}", v); }
    void value(std::uint32_t v) { m_text += std::format(" {}", v); }
    void value(std::uint64_t v) { m_text += std::format(" {}", v); }
    void value(int v) { m_text += std::format(" {}", v); }
    void value(bool v) { m_text += v ? " true" : " false"; }
    void value(const Eigen::Vector2d& p) { add(p.x(), p.y()); }
    void value(const Dimension& d) { add(d.value_m, static_cast<int>(d.provenance), d.rms_m); }
    void value(const Evidence& e)
    {
        add(e.points, e.faceCoverage[0], e.faceCoverage[1], e.facesSeen, e.rms_m, e.labelShare);
    }
    void value(const Polygon& p)
    {
        for (const Eigen::Vector2d& v : p.outer)
            value(v);
        for (const auto& hole : p.holes)
        {
            m_text += " hole";
            for (const Eigen::Vector2d& v : hole)
                value(v);
        }
    }
    template <typename... T>
    void add(const T&... values)
    {
        (value(values), ...);
    }
    std::string m_text;
};

inline std::string dump(const Building& building)
{
    return BuildingDump(building).text();
}

}  // namespace s2b::test
