// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/bcf.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace s2b::report
{

std::string nameUuid(const std::string& name)
{
    return boost::uuids::to_string(
        boost::uuids::name_generator_sha1(boost::uuids::ns::url())("scan-to-bim/report/" + name));
}

}  // namespace s2b::report
