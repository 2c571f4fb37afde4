// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/png.h"

#include "core/base/error.h"
#include "core/report/text.h"

#include <png.h>

namespace s2b::report
{

static_assert(sizeof(Color) == 4, "pixels are handed over as four bytes each");

std::string encodePng(const Image& image)
{
    png_image header = {};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
        throw Error(ErrorCode::Internal, std::string("a picture could not be encoded: ") + header.message);
    bytes.resize(size);
    return bytes;
}

std::string dataUri(const Image& image)
{
    return "data:image/png;base64," + base64(encodePng(image));
}

}  // namespace s2b::report
