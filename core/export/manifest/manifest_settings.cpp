#include "core/export/manifest/manifest_settings.h"

#include "core/export/export_option_table.h"

#include <optional>
#include <string_view>
#include <vector>

namespace fumage {

std::map<std::string, std::string> settingsOf(const ExportPlan& plan)
{
    std::map<std::string, std::string> settings;
    for (const ExportOption& option : exportOptions()) {
        if (option.setting.empty() || !option.applies(plan)) {
            continue;
        }
        if (const std::optional<std::string> text = option.text(plan); text && !text->empty()) {
            settings[std::string(option.setting)] = *text;
        }
    }
    return settings;
}

Status readSettings(const std::map<std::string, std::string>& settings, ExportPlan& plan)
{
    for (const ExportOption& option : exportOptions()) {
        if (option.setting.empty() || !option.applies(plan)) {
            continue;
        }
        const auto found = settings.find(std::string(option.setting));
        const bool isSaid = found != settings.end() && !found->second.empty();
        if (!isSaid && !option.unsaid) {
            return Error{
                ErrorCode::WrongType, makeMessage("what this manifest is of cannot be rendered again"), {}, {}};
        }
        const std::string text = isSaid ? found->second : std::string(*option.unsaid);
        const std::vector<std::string> parts =
            option.form == OptionForm::List ? splitList(text) : std::vector<std::string>{text};
        for (const std::string& part : text.empty() ? std::vector<std::string>() : parts) {
            if (Status status = option.read(part, plan); !status) {
                return status;
            }
        }
    }
    return Done{};
}

} // namespace fumage
