#pragma once

#include "core/base/message.h"

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace fumage {

/// What went wrong, for code that has to react; people read Error::text().
enum class ErrorCode {
    Cancelled,
    FileNotFound,
    NotAFile,
    PermissionDenied,
    DiskFull,
    ReadFailed,
    WriteFailed,
    NotUtf8,
    Syntax,
    TooDeep,
    TooLarge,
    WrongType,
    WrongVersion,
    NotFinite,
    UnknownKey,
    UnknownName,
    OutOfRange,
    OutOfMemory,
    WouldOverwrite,
    Mismatch, ///< what was to be the same is not
};

/// An expected failure: what happened, where, and what the user can do about it.
struct Error {
    ErrorCode code = ErrorCode::ReadFailed;
    Message message; ///< what happened, naming the thing
    Message place; ///< file, line and column, or key; empty where there is none
    Message remedy; ///< what to do, as an imperative; empty where the message says it

    /// "place: message. remedy".
    [[nodiscard]] Message whole() const
    {
        const Message line = place.empty() ? message : makeMessage("%1: %2", place, message);
        return remedy.empty() ? line : makeMessage("%1. %2", line, remedy);
    }

    /// whole() in English, on one line.
    [[nodiscard]] std::string text() const { return whole().text(); }
};

/// Either a value or an Error. No exception crosses a library border; this does.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) // NOLINT(google-explicit-constructor): `return value;` is the point
        : m_state(std::in_place_index<0>, std::move(value))
    {
    }
    Result(Error error) // NOLINT(google-explicit-constructor)
        : m_state(std::in_place_index<1>, std::move(error))
    {
    }

    /// Whether there is a value.
    [[nodiscard]] bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] const T& value() const&
    {
        assert(ok());
        return std::get<0>(m_state);
    }
    [[nodiscard]] T& value() &
    {
        assert(ok());
        return std::get<0>(m_state);
    }
    /// Of one that goes away: by value, so that a loop over what a function returns does not outlive it.
    [[nodiscard]] T value() &&
    {
        assert(ok());
        return std::get<0>(std::move(m_state));
    }
    /// What went wrong; only where ok() is false.
    [[nodiscard]] const Error& error() const
    {
        assert(!ok());
        return std::get<1>(m_state);
    }

private:
    std::variant<T, Error> m_state;
};

struct Done { };

/// Result of something that succeeds without a value: `return Done{};`.
using Status = Result<Done>;

} // namespace fumage
