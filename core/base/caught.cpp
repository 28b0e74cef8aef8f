#include "core/base/caught.h"

#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace fumage {

Error caughtError()
{
    const Message report = said("Please report it, with the preset that you had");
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return {ErrorCode::OutOfMemory, said("there is not enough memory"), {},
            said("Use a smaller picture or fewer particles")};
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::resource_unavailable_try_again) {
            return {ErrorCode::OutOfMemory, said("no more threads can be started"), {},
                said("Close other programs, or let this one have more threads")};
        }
        return {kUnexpected, said("something failed inside Fumage: %1", std::string(error.what())), {}, report};
    } catch (const std::exception& error) {
        return {kUnexpected, said("something failed inside Fumage: %1", std::string(error.what())), {}, report};
    } catch (...) {
        return {kUnexpected, said("something failed inside Fumage"), {}, report};
    }
}

} // namespace fumage
