#pragma once

namespace fumage::ui {

class ActionSet;
class Document;
class Player;
class Settings;
class TimelineBar;

/// Puts the actions that play, step and set the range in charge of a player.
void connectPlayActions(const ActionSet& actions, Player& player);

/// The same for those that set markers, and go from one to the next.
void connectMarkerActions(const ActionSet& actions, Player& player, Document& document);

/// The same for those that go from key frame to key frame, and set them.
void connectKeyActions(const ActionSet& actions, Player& player, Document& document);

/// The same for the one that shows the graph of key frames, which is remembered.
void connectGraphAction(const ActionSet& actions, TimelineBar& timeline, Settings& settings);

} // namespace fumage::ui
