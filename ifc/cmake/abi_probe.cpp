// SPDX-License-Identifier: GPL-3.0-or-later
// Does IfcOpenShell's library agree with the Boost headers of this build? boost::optional<enum> arguments arrive as
// garbage when it was compiled against another Boost. Run when CMake configures; exit code 0 when they agree.
#include <ifcparse/Ifc4.h>
#include <ifcparse/IfcFile.h>

#include <exception>
#include <iostream>
#include <sstream>
#include <string>

namespace
{

std::string text(IfcParse::IfcFile& file, boost::optional<Ifc4::IfcSIPrefix::Value> prefix)
{
    auto* unit = new Ifc4::IfcSIUnit(Ifc4::IfcUnitEnum::IfcUnit_LENGTHUNIT, prefix,
                                     Ifc4::IfcSIUnitName::IfcSIUnitName_METRE);  // the file owns it from here on
    std::ostringstream out;
    file.addEntity(unit)->toString(out, true);
    return out.str();
}

}  // namespace

int main()
{
    try
    {
        IfcParse::IfcFile file(IfcParse::schema_by_name("IFC4"));
        const std::string with = text(file, Ifc4::IfcSIPrefix::IfcSIPrefix_MILLI);
        const std::string without = text(file, boost::none);
        std::cout << with << '\n' << without << '\n';
        const bool agrees = with.find(".LENGTHUNIT.,.MILLI.,.METRE.") != std::string::npos &&
                            without.find(".LENGTHUNIT.,$,.METRE.") != std::string::npos;
        return agrees ? 0 : 1;
    }
    catch (const std::exception& e)
    {
        std::cout << e.what() << '\n';
        return 1;
    }
}
