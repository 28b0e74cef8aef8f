#pragma once

#include <string>
#include <string_view>

namespace fumage {

/// All texts of a range, with a separator between them.
template <class Range>
[[nodiscard]] std::string joined(const Range& texts, std::string_view separator = ", ")
{
    std::string all;
    for (const auto& text : texts) {
        if (!all.empty()) {
            all += separator;
        }
        all += text;
    }
    return all;
}

} // namespace fumage
