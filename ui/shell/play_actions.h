#pragma once

namespace fumage::ui {

class ActionSet;
class Player;

/// Puts the actions that play, step and set the range in charge of a player.
void connectPlayActions(const ActionSet& actions, Player& player);

} // namespace fumage::ui
