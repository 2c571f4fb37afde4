// SPDX-License-Identifier: GPL-3.0-or-later
#include "ifc/save_file.h"

#include "core/base/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace s2b::ifc
{
namespace
{

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
    throw Error(ErrorCode::CannotWrite, "can't write " + path + ": " + reason);
}

std::string reasonOf(int error)
{
    return std::generic_category().message(error);
}

/// 0 or the errno. A full disk may only show when the data is flushed or the file closed.
int writeAndClose(int file, std::string_view content, bool flush)
{
    int error = 0;
    while (!content.empty() && error == 0)
    {
        const ssize_t count = ::write(file, content.data(), content.size());
        if (count >= 0)
            content.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            error = errno;
    }
    if (error == 0 && flush && ::fsync(file) != 0)
        error = errno;
    if (::close(file) != 0 && error == 0)
        error = errno;
    return error;
}

}  // namespace

void saveFile(const std::string& path, std::string_view content)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status))
        fail(path, "it is a folder; give a file name");
    if (fs::exists(status) && !fs::is_regular_file(status))
    {
        const int device = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        const int error = device < 0 ? errno : writeAndClose(device, content, false);
        if (error != 0)
            fail(path, reasonOf(error));
        return;
    }
    if (fs::exists(status) && ::access(path.c_str(), W_OK) != 0)
        fail(path, reasonOf(errno));

    fs::path target = path;
    if (fs::is_symlink(fs::symlink_status(path, ignored)))
        target = fs::weakly_canonical(path, ignored);
    const std::string pattern = target.string() + ".partial-XXXXXX";
    std::vector<char> partial(pattern.begin(), pattern.end());
    partial.push_back('\0');
    const int file = ::mkostemp(partial.data(), O_CLOEXEC);
    if (file < 0)
        fail(path, reasonOf(errno));

    // mkostemp makes a private file; ours gets the rights of the file that it replaces, or the usual ones.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    struct stat old = {};
    const mode_t mode = ::stat(target.c_str(), &old) == 0 ? (old.st_mode & 07777U) : (0666U & ~mask);
    int error = ::fchmod(file, mode) == 0 ? 0 : errno;
    const int writeError = writeAndClose(file, content, true);
    if (error == 0)
        error = writeError;
    if (error == 0 && ::rename(partial.data(), target.c_str()) != 0)
        error = errno;
    if (error != 0)
    {
        ::unlink(partial.data());
        fail(path, reasonOf(error));
    }
}

}  // namespace s2b::ifc
