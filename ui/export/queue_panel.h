#pragma once

#include "ui/export/export_queue.h"
#include "ui/widgets/file_question.h"

#include <QWidget>

class QAction;
class QLabel;
class QListView;

namespace fumage::ui {

/// The exports that wait, run and are done, with all that can be done to them.
class QueuePanel : public QWidget {
    Q_OBJECT

public:
    /// @param askForFile for the name of a file with the list
    QueuePanel(ExportQueue& queue, AskForFile askForFile, QWidget* parent = nullptr);

signals:
    /// What a plan says is to be exported again, with the smoke as it is now.
    void againRequested(const fumage::ExportPlan& plan);
    /// The list cannot be saved.
    void failed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QAction* addAction(
        const char* name, const QString& icon, const QString& text, const std::function<void(int row)>& act);
    void buildActions();
    QWidget* makeNotice();
    /// That of the one that is chosen; less than 0: none.
    [[nodiscard]] int row() const;
    void move(int from, int before);
    void cancelOrRemove(int row);
    void showInFolder(int row) const;
    void saveList();
    /// Says what there is, and what can be done to the one that is chosen; does nothing while nobody sees it.
    void follow();

    ExportQueue& m_queue;
    const AskForFile m_askForFile;
    QListView* m_list;
    QLabel* m_left; ///< how many exports are left from before
    QWidget* m_notice; ///< of them
    QAction* m_start = nullptr;
    QAction* m_up = nullptr;
    QAction* m_down = nullptr;
    QAction* m_rename = nullptr;
    QAction* m_stop = nullptr;
    QAction* m_verify = nullptr;
    QAction* m_folder = nullptr;
    QAction* m_again = nullptr;
    QAction* m_clear = nullptr;
    QAction* m_save = nullptr;
};

} // namespace fumage::ui
