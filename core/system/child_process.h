#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace fumage {

/// Another program that is fed through its standard input, and whose messages are kept. It is ended with the object,
/// whatever it is doing then.
class ChildProcess {
public:
    /// @param program   a name on the search path, or a path
    /// @param arguments those after its name
    /// @error FileNotFound, PermissionDenied, NotAFile; OutOfMemory where the system has no more processes or files to
    /// give; the place is the program
    [[nodiscard]] static Result<ChildProcess> start(
        const std::string& program, const std::vector<std::string>& arguments);

    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept = delete;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Hands bytes over; waits until the program has taken them.
    /// @error WriteFailed with what the program said, where it has ended; Cancelled
    [[nodiscard]] Status write(std::span<const std::byte> bytes, const std::stop_token& stop = {});

    /// Says that nothing follows, and waits until the program has ended.
    /// @error WriteFailed with what the program said, where it did not end well; Cancelled
    [[nodiscard]] Status finish(const std::stop_token& stop = {});

private:
    /// The program as the system knows it; ended with its object.
    class Running;

    explicit ChildProcess(std::unique_ptr<Running> running);

    std::unique_ptr<Running> m_running;
};

} // namespace fumage
