#include "core/system/child_errors.h"

#include "core/system/file_error.h"
#include "core/system/path.h"
#include "core/base/text.h"

#include <algorithm>

namespace fumage {

void keepEnd(std::string& said, std::string_view more)
{
    said.append(more);
    said.erase(0, said.size() - std::min(said.size(), kMaxChildSays));
}

Error childNotStarted(int number, const std::string& program, const std::string& reason)
{
    Error error = fileError(number, pathFrom(program), ErrorCode::FileNotFound, FileUse::Read);
    error.message = makeMessage("the program cannot be started: %1", reason);
    return error;
}

Error childFailed(const std::string& program, std::string_view words)
{
    const std::string_view reason = trimmed(words);
    return {ErrorCode::WriteFailed,
        reason.empty() ? makeMessage("the program ended by itself")
                       : makeMessage("the program failed: %1", std::string(reason)),
        program, {}};
}

Error childCancelled()
{
    return {ErrorCode::Cancelled, makeMessage("the video was cancelled"), {}, {}};
}

} // namespace fumage
