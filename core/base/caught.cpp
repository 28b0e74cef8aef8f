#include "core/base/caught.h"

#include <array>
#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace fumage {

namespace {

Error systemFailure(const std::system_error& cause)
{
    constexpr std::array kPassing{std::errc::resource_unavailable_try_again, std::errc::not_enough_memory,
        std::errc::too_many_files_open, std::errc::too_many_files_open_in_system};
    for (const std::errc lack : kPassing) {
        if (cause.code() == lack) {
            return {ErrorCode::OutOfMemory,
                makeMessage("the system gives no more threads, files or memory: %1", cause.code().message()), {},
                makeMessage("End other programs, raise its limits (ulimit -u, -n, -v), or use --threads 1")};
        }
    }
    return {ErrorCode::PermissionDenied, makeMessage("the system refuses what is needed: %1", cause.what()), {},
        makeMessage("Use another folder or another machine")};
}

} // namespace

Error caughtError()
{
    const Message report = makeMessage("Please report it, with the preset that you had");
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return {ErrorCode::OutOfMemory, makeMessage("there is not enough memory"), {},
            makeMessage("Use a smaller picture or fewer particles")};
    } catch (const std::system_error& cause) {
        return systemFailure(cause);
    } catch (const std::exception& error) {
        return {kUnexpected, makeMessage("something failed inside Fumage: %1", std::string(error.what())), {}, report};
    } catch (...) {
        return {kUnexpected, makeMessage("something failed inside Fumage"), {}, report};
    }
}

} // namespace fumage
