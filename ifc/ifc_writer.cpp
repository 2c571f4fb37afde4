// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/ifc_writer.h"

#include "core/base/error.h"
#include "core/base/save_file.h"
#include "ifc/check.h"
#include "ifc/model.h"

#include <exception>
#include <string>

namespace s2b::ifc
{
namespace
{

std::string ifcText(const Building& building, const WriteOptions& options)
{
    try
    {
        Model model(building, options);
        model.addWalls();
        model.addOpenings();
        model.addColumns();
        model.addSlabs();
        model.addSpaces();
        model.addJunctions();
        model.finish();
        return model.text();
    }
    catch (const Error&)
    {
        throw;
    }
    catch (const std::exception& e)
    {
        throw Error(ErrorCode::Internal, std::string("the model can't be written as IFC: ") + e.what());
    }
}

}  // namespace

void writeIfc(const Building& building, const std::string& path, const WriteOptions& options)
{
    checkWritable(building, options);
    saveFile(path, ifcText(building, options));
}

}  // namespace s2b::ifc
