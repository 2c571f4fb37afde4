// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/save_file.h"

#include "core/base/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>

namespace s2b
{
namespace fs = std::filesystem;
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

/// Content on the disk beside its place; gone again unless it is put there.
class Partial
{
public:
    Partial(std::string path, std::string_view content) : m_path(std::move(path)), m_target(m_path)
    {
        std::error_code ignored;
        const fs::file_status status = fs::status(m_path, ignored);
        if (fs::is_directory(status))
            fail(m_path, "it is a folder; give a file name");
        if (fs::exists(status) && ::access(m_path.c_str(), W_OK) != 0)
            fail(m_path, reasonOf(errno));
        if (fs::is_symlink(fs::symlink_status(m_path, ignored)))
            m_target = fs::weakly_canonical(m_path, ignored).string();
        std::string name = m_target + ".partial-XXXXXX";
        const int file = ::mkostemp(name.data(), O_CLOEXEC);
        if (file < 0)
            fail(m_path, reasonOf(errno));
        m_name = std::move(name);

        // mkostemp makes a private file; ours gets the rights of the file that it replaces, or the usual ones.
        const mode_t mask = ::umask(0);
        ::umask(mask);
        struct stat old = {};
        const mode_t mode = ::stat(m_target.c_str(), &old) == 0 ? (old.st_mode & 07777U) : (0666U & ~mask);
        int error = ::fchmod(file, mode) == 0 ? 0 : errno;
        const int writeError = writeAndClose(file, content, true);
        if (error == 0)
            error = writeError;
        if (error != 0)
        {
            ::unlink(m_name.c_str());  // no destructor runs
            fail(m_path, reasonOf(error));
        }
    }
    ~Partial()
    {
        if (!m_name.empty())
            ::unlink(m_name.c_str());
    }
    Partial(const Partial&) = delete;
    Partial& operator=(const Partial&) = delete;

    void putInPlace()
    {
        if (::rename(m_name.c_str(), m_target.c_str()) != 0)
            fail(m_path, reasonOf(errno));
        m_name.clear();
    }

private:
    std::string m_path;    ///< as it was asked for
    std::string m_target;  ///< what a link leads to
    std::string m_name;    ///< meanwhile; empty once it is in place
};

/// Folders that go again unless they are kept.
class MadeFolders
{
public:
    explicit MadeFolders(const fs::path& place)
    {
        std::error_code error;
        for (fs::path made = place; !made.empty() && !fs::exists(made, error) && made != made.root_path();
             made = made.parent_path())
            m_folders.push_back(made);
        fs::create_directories(place, error);
        if (error)
            fail(place.string(), reasonOf(error.value()));
    }
    ~MadeFolders()
    {
        std::error_code ignored;
        for (const fs::path& folder : m_folders)  // innermost first
            fs::remove(folder, ignored);          // only when it is empty
    }
    MadeFolders(const MadeFolders&) = delete;
    MadeFolders& operator=(const MadeFolders&) = delete;
    void keep() { m_folders.clear(); }

private:
    std::vector<fs::path> m_folders;
};

}  // namespace

void saveFile(const std::string& path, std::string_view content)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
    {
        const int device = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        const int error = device < 0 ? errno : writeAndClose(device, content, false);
        if (error != 0)
            fail(path, reasonOf(error));
        return;
    }
    Partial(path, content).putInPlace();
}

void saveFiles(const std::string& folder, const std::vector<std::pair<std::string, std::string>>& files)
{
    std::error_code error;
    const fs::path place = fs::absolute(folder, error);
    if (fs::exists(place, error) && !fs::is_directory(place, error))
        throw Error(ErrorCode::CannotWrite, "can't write into " + folder + ": it is a file, give a folder");
    MadeFolders made(place);
    std::vector<std::unique_ptr<Partial>> partials;
    for (const auto& [name, content] : files)
        partials.push_back(std::make_unique<Partial>((place / name).string(), content));
    for (const auto& partial : partials)
        partial->putInPlace();
    made.keep();
}

}  // namespace s2b
