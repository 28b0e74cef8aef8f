#pragma once

#include "core/system/descriptor.h"

#include <filesystem>
#include <memory>
#include <utility>

namespace fumage {

/// A file that says that a running program owns what it is named after. The system ends the lock with its program,
/// however that ends: a file that was left alone, empty or not, can be had. Taken away with the lock.
class FileLock {
public:
    /// @return the lock, or nothing where another holds it, in this program or elsewhere, or the file cannot be made.
    /// Where the file system has no flock nothing is locked
    [[nodiscard]] static std::unique_ptr<FileLock> tryTake(const std::filesystem::path& file);

    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    FileLock(FileLock&&) = delete;
    FileLock& operator=(FileLock&&) = delete;

private:
    FileLock(std::filesystem::path file, Descriptor descriptor)
        : m_file(std::move(file))
        , m_descriptor(std::move(descriptor))
    {
    }

    std::filesystem::path m_file;
    Descriptor m_descriptor;
};

} // namespace fumage
