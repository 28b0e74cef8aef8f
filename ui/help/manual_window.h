#pragma once

#include "ui/help/manual.h"
#include "ui/help/manual_search.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QStackedWidget;
class QToolButton;
class QTreeWidget;
class QUrl;

namespace fumage::ui {

class ManualView;

/// The manual beside the work: contents or what a search has found on the left, a page on the right, the way that one
/// has gone, and a larger or smaller text. Nothing outside the manual is opened: where a link leads there, its address
/// is shown.
class ManualWindow : public QDialog {
    Q_OBJECT

public:
    /// @param manual has pages
    ManualWindow(Manual manual, QWidget* parent);

    /// Goes to the key of a parameter or the name of a group; to the first page where it is empty or unknown, which is
    /// said.
    void showAt(const QString& anchor);
    [[nodiscard]] ManualPlace place() const { return m_way.value(m_at); }
    [[nodiscard]] const Manual& manual() const { return m_manual; }

private:
    void build();
    [[nodiscard]] QWidget* makeBar();
    void addShortcuts();
    void fillContents();
    void go(const ManualPlace& place);
    void goBy(int steps);
    void showPlace();
    void follow(const QUrl& link);
    void search(const QString& words);
    void openHit(int row);
    void nextHit();

    const Manual m_manual;
    QList<ManualPlace> m_way; ///< places that were looked at
    int m_at = -1; ///< among them; -1: none was
    int m_shownPage = -1; ///< index; -1: none
    QList<ManualHit> m_hits;
    QToolButton* m_back;
    QToolButton* m_forward;
    QLineEdit* m_search;
    QStackedWidget* m_side;
    QTreeWidget* m_contents;
    QListWidget* m_found;
    ManualView* m_view;
    QLabel* m_note;
};

} // namespace fumage::ui
