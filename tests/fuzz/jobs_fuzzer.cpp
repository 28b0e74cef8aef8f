// Any bytes are either refused with a message, or read, written and read again to the same jobs.

#include "expect.h"

#include "core/export/jobs/job_file.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace fumage;
    const Result<JobsReading> first = parseJobs({reinterpret_cast<const char*>(data), size});
    if (!first) {
        FUMAGE_EXPECT(!first.error().message.empty());
        return 0;
    }
    const std::string json = formatJobs(first.value().jobs);
    const Result<JobsReading> second = parseJobs(json);
    FUMAGE_EXPECT(second.ok());
    FUMAGE_EXPECT(formatJobs(second.value().jobs) == json);
    return 0;
}
