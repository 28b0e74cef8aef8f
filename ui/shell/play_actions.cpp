#include "ui/shell/play_actions.h"

#include "ui/document/key_edits.h"
#include "ui/document/marker_edits.h"
#include "ui/shell/action_table.h"
#include "ui/shell/settings.h"
#include "ui/timeline/player.h"
#include "ui/timeline/timeline_bar.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fumage::ui {

namespace {

/// Shows the frame of the next time, or of the one before the frame that is shown; nothing happens where there is none.
/// @param times in order, s
void goToNext(Player& player, const Document& document, const std::vector<double>& times, bool forward)
{
    const double rate = document.scene().timeline.frameRate;
    std::optional<int> next;
    for (const double seconds : times) {
        const int frame = static_cast<int>(std::lround(seconds * rate));
        if (forward ? frame > player.frame() && !next : frame < player.frame()) {
            next = frame;
        }
    }
    if (next) {
        player.pause();
        player.setFrame(*next);
    }
}

} // namespace

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
    const auto go = [&player, &document](bool forward) { goToNext(player, document, keyTimes(document), forward); };
    actions.on("play.nextKey", &player, [go] { go(true); });
    actions.on("play.previousKey", &player, [go] { go(false); });
    QObject::connect(&actions.get("play.autoKey"), &QAction::toggled, &document, &Document::setAutoKey);
}

void connectMarkerActions(const ActionSet& actions, Player& player, Document& document)
{
    const auto go = [&player, &document](bool forward) { goToNext(player, document, markerTimes(document), forward); };
    actions.on("play.addMarker", &player, [&document] { addMarkerHere(document); });
    actions.on("play.nextMarker", &player, [go] { go(true); });
    actions.on("play.previousMarker", &player, [go] { go(false); });
}

void connectGraphAction(const ActionSet& actions, TimelineBar& timeline, Settings& settings)
{
    QAction& action = actions.get("play.graph");
    QObject::connect(&action, &QAction::toggled, &timeline, &TimelineBar::setShowsGraph);
    QObject::connect(&timeline, &TimelineBar::graphToggled, &action, &QAction::setChecked);
    QObject::connect(&timeline, &TimelineBar::graphToggled, &settings, &Settings::setShowsGraph);
    QObject::connect(&timeline, &TimelineBar::graphHeightChanged, &settings, &Settings::setGraphHeight);
    timeline.setShowsGraph(settings.showsGraph());
    timeline.setGraphHeight(settings.graphHeight(timeline.graphHeight()));
}

} // namespace fumage::ui
