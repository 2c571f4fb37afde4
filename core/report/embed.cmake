# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DINPUT=x.tpl -DOUTPUT=x.cpp -DNAME=kX -P embed.cmake: a text file as a constant of the program.
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}" "// Made by the build from a template of the report.
#include \"core/report/template.h\"
namespace s2b::report
{
const std::string_view ${NAME} = R\"s2b(${text})s2b\";
}  // namespace s2b::report
")
