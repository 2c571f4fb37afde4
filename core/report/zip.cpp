// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/zip.h"

#include "core/base/error.h"

#include <minizip/zip.h>
#include <zlib.h>

#include <algorithm>

namespace s2b::report
{
namespace
{

/// What minizip takes for a file, in memory.
struct MemoryFile
{
    std::string bytes;
    std::size_t place = 0;
};

voidpf openFile(voidpf memory, const void*, int)
{
    return memory;
}

uLong readFile(voidpf, voidpf stream, void* to, uLong count)
{
    MemoryFile& file = *static_cast<MemoryFile*>(stream);
    const std::size_t start = std::min(file.place, file.bytes.size());
    const std::size_t size = std::min<std::size_t>(count, file.bytes.size() - start);
    file.bytes.copy(static_cast<char*>(to), size, start);
    file.place = start + size;
    return static_cast<uLong>(size);
}

uLong writeFile(voidpf, voidpf stream, const void* from, uLong count)
{
    MemoryFile& file = *static_cast<MemoryFile*>(stream);
    if (file.bytes.size() < file.place + count)
        file.bytes.resize(file.place + count);
    std::copy_n(static_cast<const char*>(from), count, file.bytes.begin() + static_cast<std::ptrdiff_t>(file.place));
    file.place += count;
    return count;
}

ZPOS64_T tellFile(voidpf, voidpf stream)
{
    return static_cast<MemoryFile*>(stream)->place;
}

long seekFile(voidpf, voidpf stream, ZPOS64_T offset, int origin)
{
    MemoryFile& file = *static_cast<MemoryFile*>(stream);
    const ZPOS64_T from = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                          : origin == ZLIB_FILEFUNC_SEEK_CUR ? file.place
                                                             : file.bytes.size();
    file.place = static_cast<std::size_t>(from + offset);
    return 0;
}

int succeed(voidpf, voidpf)
{
    return 0;
}

void check(int result)
{
    if (result != ZIP_OK)
        throw Error(ErrorCode::Internal,
                    "the archive of the issues could not be made (minizip: " + std::to_string(result) + ")");
}

}  // namespace

std::string makeZip(const std::vector<std::pair<std::string, std::string>>& files)
{
    MemoryFile memory;
    zlib_filefunc64_def functions = {};
    functions.zopen64_file = openFile;
    functions.zread_file = readFile;
    functions.zwrite_file = writeFile;
    functions.ztell64_file = tellFile;
    functions.zseek64_file = seekFile;
    functions.zclose_file = succeed;
    functions.zerror_file = succeed;
    functions.opaque = &memory;
    const zipFile zip = zipOpen2_64("issues", APPEND_STATUS_CREATE, nullptr, &functions);
    if (!zip)
        throw Error(ErrorCode::Internal, "the archive of the issues could not be made");

    zip_fileinfo info = {};
    info.tmz_date.tm_year = 1980;
    info.tmz_date.tm_mday = 1;
    for (const auto& [path, content] : files)
    {
        check(zipOpenNewFileInZip(zip, path.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                                  Z_DEFAULT_COMPRESSION));
        check(zipWriteInFileInZip(zip, content.data(), static_cast<unsigned>(content.size())));
        check(zipCloseFileInZip(zip));
    }
    check(zipClose(zip, nullptr));
    return std::move(memory.bytes);
}

}  // namespace s2b::report
