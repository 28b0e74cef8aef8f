// What follows --set is either refused with a message, or leaves every parameter in its range. A value that was taken
// reads back as itself.

#include "tests/fuzz/expect.h"

#include "core/effect/parameter_table.h"
#include "core/effect/assignment.h"
#include "core/effect/value.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

using namespace fumage;

void assign(std::string_view text)
{
    Effect effect;
    const Result<bool> clamped = applyAssignment(effect, text);
    FUMAGE_EXPECT(clamped || !clamped.error().message.empty());
    for (const Parameter& parameter : parameterTable()) {
        FUMAGE_EXPECT(!clampValue(parameter, parameter.get(effect)).changed);
    }
}

void readBack(const Parameter& parameter, std::string_view text)
{
    const Result<Clamped> parsed = parseValue(parameter, text);
    if (parsed) {
        const Value value = clampValue(parameter, parsed.value().value).value;
        const Result<Clamped> again = parseValue(parameter, formatText(parameter, value));
        FUMAGE_EXPECT(again && again.value().value == value && !again.value().changed);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    assign(text);
    if (!text.empty()) {
        const auto table = parameterTable();
        const Parameter& parameter = table[data[0] % table.size()];
        readBack(parameter, text.substr(1));
        assign(std::string(parameter.key) + "=" + std::string(text.substr(1)));
    }
    return 0;
}
