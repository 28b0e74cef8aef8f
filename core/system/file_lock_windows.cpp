#include "core/system/file_lock.h"

#include "core/base/windows_api.h"

namespace fumage {

std::unique_ptr<FileLock> FileLock::tryTake(const std::filesystem::path& file)
{
    // Shared with nobody is locked; and the system deletes it, however the program ends.
    Descriptor descriptor(::CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, 0, nullptr, OPEN_ALWAYS,
        FILE_FLAG_DELETE_ON_CLOSE, nullptr));
    return descriptor ? std::unique_ptr<FileLock>(new FileLock(file, std::move(descriptor)))
                      : nullptr; // NOLINT(cppcoreguidelines-owning-memory): its constructor is private
}

FileLock::~FileLock() = default;

} // namespace fumage
