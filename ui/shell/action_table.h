#pragma once

#include <QAction>
#include <QObject>

#include <span>

namespace fumage::ui {

/// One row of the table of actions: menus, shortcuts, tool bar, command search and shortcut sheet are all made from it.
struct ActionSpec {
    const char* id; ///< objectName of the QAction
    const char* menu; ///< key for tr(); the menu that it stands in
    const char* text; ///< key for tr()
    const char* keys = ""; ///< "Ctrl+S", or a list with "; "; empty where there is none
    const char* icon = ""; ///< empty: none
    bool checkable = false;
    bool beginsSection = false; ///< a line above it in the menu
};

[[nodiscard]] std::span<const ActionSpec> actionSpecs();

/// A text of the table in the language of the user.
[[nodiscard]] QString actionText(const char* key);

/// The text of an action without its mnemonic, with the menu it stands in: "View: Frame all".
[[nodiscard]] QString fullName(const ActionSpec& spec);

/// The actions of one window, made from the table.
class ActionSet : public QObject {
    Q_OBJECT

public:
    explicit ActionSet(QWidget* window);

    /// @param id of a row; anything else is a mistake in the program
    [[nodiscard]] QAction& get(const char* id) const;
    template <class Receiver, class Slot>
    void on(const char* id, Receiver* receiver, Slot slot) const
    {
        QObject::connect(&get(id), &QAction::triggered, receiver, slot);
    }
};

} // namespace fumage::ui
