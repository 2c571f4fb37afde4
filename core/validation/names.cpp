// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/validation/validation.h"

namespace s2b::validation
{

const char* className(ElementClass elementClass)
{
    switch (elementClass)
    {
        case ElementClass::Wall:
            return "wall";
        case ElementClass::Door:
            return "door";
        case ElementClass::Window:
            return "window";
        case ElementClass::Column:
            return "column";
        case ElementClass::Slab:
            return "slab";
        case ElementClass::Space:
            return "space";
    }
    return "";
}

const char* loaName(LoaBand band)
{
    switch (band)
    {
        case LoaBand::NoData:
            return "no data";
        case LoaBand::Beyond:
            return "beyond LOA10";
        case LoaBand::Loa10:
            return "LOA10";
        case LoaBand::Loa20:
            return "LOA20";
        case LoaBand::Loa30:
            return "LOA30";
        case LoaBand::Loa40:
            return "LOA40";
        case LoaBand::Loa50:
            return "LOA50";
    }
    return "";
}

}  // namespace s2b::validation
