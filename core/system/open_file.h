#pragma once

#include "core/system/descriptor.h"
#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace fumage {

/// A regular file that is open for reading.
class OpenFile {
public:
    /// @error those of readFile() but TooLarge
    [[nodiscard]] static Result<OpenFile> open(const std::filesystem::path& path);

    /// In bytes, as it was opened.
    [[nodiscard]] std::size_t size() const { return m_size; }

    /// @param size of what is read; less where the file has become shorter
    /// @error ReadFailed; the place is the path
    [[nodiscard]] Result<std::string> read(std::size_t size) const;

    /// The same from any place; where read() goes on afterwards is not said.
    /// @param at from the beginning; behind what was the end when the file was opened there is nothing
    [[nodiscard]] Result<std::string> readAt(std::uint64_t at, std::size_t size) const;

private:
    OpenFile(std::filesystem::path path, Descriptor descriptor, std::size_t size)
        : m_path(std::move(path))
        , m_descriptor(std::move(descriptor))
        , m_size(size)
    {
    }

    std::filesystem::path m_path;
    Descriptor m_descriptor;
    std::size_t m_size = 0;
};

} // namespace fumage
