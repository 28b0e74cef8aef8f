#include "ui/shell/play_actions.h"

#include "ui/document/key_edits.h"
#include "ui/shell/action_table.h"
#include "ui/timeline/player.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fumage::ui {

void connectPlayActions(const ActionSet& actions, Player& player)
{
    actions.on("play.toggle", &player, &Player::toggle);
    actions.on("play.forward", &player, [&player] { player.stepBy(1); });
    actions.on("play.back", &player, [&player] { player.stepBy(-1); });
    actions.on("play.start", &player, &Player::toStart);
    actions.on("play.end", &player, &Player::toEnd);
    actions.on(
        "play.in", &player, [&player] { player.setRange(player.frame(), std::max(player.frame(), player.last())); });
    actions.on(
        "play.out", &player, [&player] { player.setRange(std::min(player.frame(), player.first()), player.frame()); });
    actions.on("play.wholeRange", &player, [&player] { player.setRange(0, player.length() - 1); });
}

void connectKeyActions(const ActionSet& actions, Player& player, Document& document)
{
    const auto go = [&player, &document](bool forward) {
        const double rate = document.scene().timeline.frameRate;
        std::optional<int> next;
        for (const double seconds : keyTimes(document)) {
            const int frame = static_cast<int>(std::lround(seconds * rate));
            if (forward ? frame > player.frame() && !next : frame < player.frame()) {
                next = frame;
            }
        }
        if (next) {
            player.pause();
            player.setFrame(*next);
        }
    };
    actions.on("play.nextKey", &player, [go] { go(true); });
    actions.on("play.previousKey", &player, [go] { go(false); });
    QObject::connect(&actions.get("play.autoKey"), &QAction::toggled, &document, &Document::setAutoKey);
}

} // namespace fumage::ui
