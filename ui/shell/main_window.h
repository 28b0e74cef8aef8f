#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/document/recovery.h"
#include "ui/shell/action_table.h"
#include "ui/shell/document_files.h"
#include "ui/shell/session.h"
#include "ui/timeline/player.h"

#include <QElapsedTimer>
#include <QMainWindow>

class QLabel;

namespace fumage::ui {

class EffectPanel;
class ExportDialog;
class ExportJob;
class NoisePane;
class PresetBrowser;
class TimelineBar;
class VariationsPanel;
class Viewport;

/// One window on one document: puts the parts together and connects them.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Session& session);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return m_document; }
    [[nodiscard]] Player& player() { return m_player; }
    [[nodiscard]] Viewport& viewport() { return *m_viewport; }
    [[nodiscard]] NoisePane& noisePane() { return *m_noisePane; }
    [[nodiscard]] ExportJob& exportJob() { return *m_exportJob; }
    [[nodiscard]] DocumentFiles& files() { return m_files; }
    [[nodiscard]] ActionSet& actions() { return m_actions; }

    /// Says something that must not be missed and need not be answered.
    void notify(const QString& message);
    /// What an empty session shows first.
    void begin();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildDocks();
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
    void buildMenus();
    void buildToolBar();
    void addChoices(QMenu& menu);
    void rebuildRecentFiles();
    void connectFileActions();
    void connectEditActions();
    void connectViewActions();
    void connectPlayActions();
    void connectCompareActions();
    void connectHelpActions();
    void connectPresets();
    void connectExport();
    void raiseDock(const QString& name);
    void showTitle();
    void arrangeDocks();
    void restoreLayout();
    void saveLayout();
    [[nodiscard]] QStringList shownOverlays() const; ///< their actions, but for those that are not remembered
    void compare(bool split, bool other);

    Session& m_session;
    Document m_document;
    Player m_player;
    Locks m_locks;
    ActionSet m_actions;
    DocumentFiles m_files;
    Recovery m_recovery;
    Effect m_other; ///< B of the comparison
    QElapsedTimer m_sinceB; ///< since its key went down
    EffectPanel* m_effectPanel = nullptr;
    NoisePane* m_noisePane = nullptr;
    TimelineBar* m_timeline = nullptr;
    Viewport* m_viewport = nullptr;
    PresetBrowser* m_browser = nullptr;
    VariationsPanel* m_variations = nullptr;
    ExportJob* m_exportJob = nullptr;
    ExportDialog* m_exportDialog = nullptr;
    QMenu* m_recentMenu = nullptr;
    QHash<QString, QDockWidget*> m_docks;
};

} // namespace fumage::ui
