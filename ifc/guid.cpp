// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/guid.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid.hpp>

#include <cstdint>

namespace s2b::ifc
{

std::string globalId(std::string_view nameSpace, std::string_view name)
{
    static constexpr std::string_view kDigits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
    std::string text = "scan-to-bim/";
    text.append(nameSpace).append("/").append(name);
    const boost::uuids::uuid uuid = boost::uuids::name_generator_sha1(boost::uuids::ns::url())(text);

    // 128 bits in base 64: two digits for the first byte, then four for each three bytes.
    std::string id(22, '0');
    std::size_t place = 0;
    const auto put = [&](std::uint32_t bits, std::size_t digits)
    {
        for (std::size_t i = digits; i-- > 0; bits >>= 6)
            id[place + i] = kDigits[bits & 63U];
        place += digits;
    };
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(uuid.begin()[i]); };
    put(byte(0), 2);
    for (std::size_t i = 1; i < 16; i += 3)
        put(byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2), 4);
    return id;
}

}  // namespace s2b::ifc
