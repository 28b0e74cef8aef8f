#pragma once

#include "core/base/result.h"
#include "core/export/export_plan.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fumage {

/// How the value of an option stands in a list of jobs, which is JSON.
enum class OptionForm {
    Text,
    Path,
    Whole, ///< a number without a fraction
    Number,
    Flag, ///< true or false
    Points, ///< of a curve, "[[0, 0], [1, 1]]"
    List, ///< of texts; as one text they have semicolons between them
};

/// One option of an export, wherever it is set: in lists of jobs, on the command line, in the settings of manifests. It
/// has the same text in all of them.
struct ExportOption {
    std::string_view key; ///< in lists of jobs; on the command line with dashes
    std::string_view flag{}; ///< on the command line, where it has another name there, as in "--for"
    std::string_view setting{}; ///< in manifests; empty: what files hold does not depend on it
    std::optional<std::string_view> unsaid{}; ///< what manifests mean that lack it; none: they are not understood
    OptionForm form = OptionForm::Text;
    double low = 0.0; ///< least number
    double high = 0.0;
    std::string_view type{}; ///< what stands for its value in help texts
    std::string_view help{}; ///< empty: it is not on the command line, or in a way of its own
    std::string_view initial{}; ///< what the command line sets where nobody says otherwise; empty: nothing
    std::vector<std::string> (*choices)() = nullptr; ///< all texts that there are; null: too many to list
    bool (*applies)(const ExportPlan& plan) = nullptr; ///< whether an export of this kind asks for it
    std::optional<std::string> (*text)(const ExportPlan& plan) = nullptr; ///< none: nobody has set it
    /// Sets it. Of a list: adds one.
    /// @error without place
    Status (*read)(std::string_view text, ExportPlan& plan) = nullptr;
};

} // namespace fumage
