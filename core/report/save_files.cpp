// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/save_files.h"

#include "core/base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace s2b::report
{
namespace fs = std::filesystem;
namespace
{

[[noreturn]] void fail(const fs::path& path, int error)
{
    throw Error(ErrorCode::CannotWrite, "can't write " + path.string() + ": " + std::generic_category().message(error));
}

/// 0 or the errno. A full disk may only show when the data is flushed or the file closed.
int writeFile(const fs::path& path, std::string_view content)
{
    constexpr mode_t kUsual = 0666;  // less what the process' mask takes away
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kUsual);
    if (file < 0)
        return errno;
    int error = 0;
    while (!content.empty() && error == 0)
    {
        const ssize_t count = ::write(file, content.data(), content.size());
        if (count >= 0)
            content.remove_prefix(static_cast<std::size_t>(count));
        else if (errno != EINTR)
            error = errno;
    }
    if (error == 0 && ::fsync(file) != 0)
        error = errno;
    if (::close(file) != 0 && error == 0)
        error = errno;
    return error;
}

/// What has to go again when it ends early: the partial files, and the folders that were made for them.
class Leftovers
{
public:
    ~Leftovers()
    {
        std::error_code ignored;
        for (const fs::path& file : files)
            fs::remove(file, ignored);
        for (const fs::path& folder : folders)
            fs::remove(folder, ignored);  // only when it is empty
    }
    std::vector<fs::path> files;
    std::vector<fs::path> folders;  ///< innermost first
};

}  // namespace

void saveFiles(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files)
{
    std::error_code error;
    const fs::path place = fs::absolute(folder, error);
    if (fs::exists(place, error) && !fs::is_directory(place, error))
        throw Error(ErrorCode::CannotWrite, "can't write the report to " + folder + ": it is a file, give a folder");

    Leftovers leftovers;
    for (fs::path made = place; !made.empty() && !fs::exists(made, error) && made != made.root_path();
         made = made.parent_path())
        leftovers.folders.push_back(made);
    fs::create_directories(place, error);
    if (error)
        fail(place, error.value());

    for (const auto& [name, content] : files)
    {
        const fs::path target = place / name;
        if (fs::is_directory(target, error))
            fail(target, EISDIR);
        if (fs::exists(target, error) && ::access(target.c_str(), W_OK) != 0)
            fail(target, errno);
        leftovers.files.push_back(place / (name + ".partial"));
        if (const int problem = writeFile(leftovers.files.back(), content))
            fail(target, problem);
    }
    for (std::size_t i = 0; i < files.size(); ++i)
    {
        const fs::path target = place / files[i].first;
        if (::rename(leftovers.files[i].c_str(), target.c_str()) != 0)
            fail(target, errno);
    }
    leftovers.folders.clear();
}

}  // namespace s2b::report
