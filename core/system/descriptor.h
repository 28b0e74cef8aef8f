#pragma once

#include <utility>

namespace fumage {

#ifdef _WIN32
using SystemFile = void*; ///< a HANDLE
#else
using SystemFile = int; ///< a file descriptor
#endif

/// What an open file is for the system; closed with the object.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(SystemFile file)
        : m_file(file)
    {
    }
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept
        : m_file(std::exchange(other.m_file, none()))
    {
    }
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(m_file, other.m_file);
        return *this;
    }
    [[nodiscard]] SystemFile get() const { return m_file; }
    /// Whether a file is open.
    explicit operator bool() const { return m_file != none(); }

private:
    /// -1: what the system gives where it cannot open a file.
    [[nodiscard]] static SystemFile none();

    SystemFile m_file = none();
};

} // namespace fumage
