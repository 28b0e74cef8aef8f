#include "ui/shell/play_actions.h"

#include "ui/shell/action_table.h"
#include "ui/timeline/player.h"

#include <algorithm>

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

} // namespace fumage::ui
