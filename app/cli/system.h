#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fumage::cli {

// What systems do in different ways: arguments, terminals, standard streams.

/// Has the standard streams carry bytes as they are, and terminals show UTF-8, as long as it lives; and has writes that
/// are larger than may be written fail instead of ending the program.
class StandardStreams {
public:
    StandardStreams();
    ~StandardStreams(); // NOLINT(performance-trivially-destructible): on Windows it has something to do
    StandardStreams(const StandardStreams&) = delete;
    StandardStreams& operator=(const StandardStreams&) = delete;
    StandardStreams(StandardStreams&&) = delete;
    StandardStreams& operator=(StandardStreams&&) = delete;

private:
    unsigned m_before = 0; ///< the code page of the terminal, which outlives the program
};

/// What follows the program's name, as UTF-8. @param argc, argv those of main()
[[nodiscard]] std::vector<std::string> argumentsOf(int argc, char** argv);

/// Whether people see what is said on standard error.
[[nodiscard]] bool isErrorOnTerminal();

/// How far reading or writing came.
struct Transferred {
    std::size_t count = 0; ///< bytes; 0 of reading: nothing follows
    bool isInterrupted = false; ///< the user did not want to wait longer
    bool isUnread = false; ///< whoever read has gone, which is a failure too
    std::string failure; ///< in the system's words; empty where there was none
};

/// Waits for what comes through standard input, or for the user to interrupt.
[[nodiscard]] Transferred readSome(std::span<char> room);
/// Waits until standard output has taken some of it, or for the user to interrupt.
[[nodiscard]] Transferred writeSome(std::span<const char> bytes);

} // namespace fumage::cli
