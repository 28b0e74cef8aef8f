#pragma once

#include <QAction>
#include <QObject>

#include <span>

class QMenu;

namespace fumage::ui {

/// What choosing a row does.
enum class ActionKind {
    Command,
    Switch, ///< can be on or off
    Submenu, ///< opens a menu of more, which is filled while the program runs
};

/// One row of the table of actions: menus, shortcuts, tool bar, command search and shortcut sheet are all made from it.
struct ActionSpec {
    const char* id; ///< objectName of the QAction, and of the QMenu of a submenu
    const char* menu; ///< key for tr(); the menu that it stands in, whose rows follow on one another
    const char* text; ///< key for tr()
    const char* keys = ""; ///< "Ctrl+S", or a list with "; "; empty where there is none
    const char* icon = ""; ///< empty: none
    ActionKind kind = ActionKind::Command;
    bool lineAbove = false; ///< in the menu
    const char* words = ""; ///< others that it is looked for by, with spaces between, the nearest first
};

[[nodiscard]] std::span<const ActionSpec> actionSpecs();

/// A text of the table in the language of the user.
[[nodiscard]] QString actionText(const char* key);

/// The same without what only a menu needs: the mark of its letter, and the dots of a dialog that follows.
[[nodiscard]] QString plainText(const char* key);

/// The plain text of an action with the menu it stands in: "View: Frame all".
[[nodiscard]] QString fullName(const ActionSpec& spec);

/// The actions of one window, made from the table.
class ActionSet : public QObject {
    Q_OBJECT

public:
    explicit ActionSet(QWidget* window);

    /// @param id of a row; anything else is a mistake in the program
    [[nodiscard]] QAction& get(const char* id) const;
    /// @param id of a row that is a submenu
    [[nodiscard]] QMenu& submenu(const char* id) const;
    template <class Receiver, class Slot>
    void on(const char* id, Receiver* receiver, Slot slot) const
    {
        QObject::connect(&get(id), &QAction::triggered, receiver, slot);
    }
};

} // namespace fumage::ui
