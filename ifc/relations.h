// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ifc/ifc_reader.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace IfcParse
{
class IfcFile;
}
namespace IfcUtil
{
class IfcBaseClass;
}

namespace s2b::ifc
{

/// Text of an attribute: a string or an enumeration's item; empty when it is unset or the entity has no such attribute.
[[nodiscard]] std::string attributeText(const IfcUtil::IfcBaseClass* instance, const char* name);

/// A number; nothing when it is unset, no number, or the entity has no such attribute.
[[nodiscard]] std::optional<double> attributeNumber(const IfcUtil::IfcBaseClass* instance, const char* name);

/// The instance that an attribute refers to; null when there is none.
[[nodiscard]] const IfcUtil::IfcBaseClass* attributeInstance(const IfcUtil::IfcBaseClass* instance, const char* name);

/// Who is part of, contained in, voiding or filling whom.
class Relations
{
public:
    explicit Relations(IfcParse::IfcFile& file);

    /// The storey that an element is in, through the elements that it is a part of or fills; null when there is none.
    [[nodiscard]] const IfcUtil::IfcBaseClass* storeyOf(const IfcUtil::IfcBaseClass* element) const;
    /// The element that an opening voids, whose opening a door or window fills, or the wall or curtain wall that these
    /// are a part of; else null.
    [[nodiscard]] const IfcUtil::IfcBaseClass* hostOf(const IfcUtil::IfcBaseClass* element) const;
    /// The element that an element is a part of; null when there is none.
    [[nodiscard]] const IfcUtil::IfcBaseClass* wholeOf(const IfcUtil::IfcBaseClass* element) const;
    /// The opening that a door or window fills; null when there is none.
    [[nodiscard]] const IfcUtil::IfcBaseClass* openingOf(const IfcUtil::IfcBaseClass* element) const;

private:
    using Parents = std::map<unsigned, const IfcUtil::IfcBaseClass*>;  // by the child's instance number
    static void collect(IfcParse::IfcFile& file, const char* entity, const char* parent, const char* children,
                        Parents& parents);
    [[nodiscard]] static const IfcUtil::IfcBaseClass* find(const Parents& parents, const IfcUtil::IfcBaseClass* child);

    Parents m_containers;
    Parents m_wholes;
    Parents m_openings;  // of what fills them
    Parents m_voided;    // of openings
};

/// IfcMapConversion of the file. @param lengthUnit_m  of the project.
[[nodiscard]] std::optional<MapConversion> mapConversionOf(IfcParse::IfcFile& file, double lengthUnit_m);

}  // namespace s2b::ifc
