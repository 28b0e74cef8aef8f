#pragma once

#include "ui/document/document.h"
#include "ui/document/locks.h"
#include "ui/document/recovery.h"
#include "ui/document/solo.h"
#include "ui/shell/action_table.h"
#include "ui/shell/comparison.h"
#include "ui/shell/docks.h"
#include "ui/shell/document_files.h"
#include "ui/shell/drop_handler.h"
#include "ui/shell/edit_actions.h"
#include "ui/shell/export_controller.h"
#include "ui/shell/file_notices.h"
#include "ui/shell/app_services.h"
#include "ui/shell/view_actions.h"
#include "ui/timeline/player.h"

#include <QMainWindow>

#include <memory>

class QShortcut;

namespace fumage::ui {

class MessageBar;
class StartDialog;
class TimelineBar;
class Viewport;

/// One window on one document: puts the parts together and connects them.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(AppServices& services);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return m_document; }
    [[nodiscard]] Solo& solo() { return m_solo; }
    [[nodiscard]] Player& player() { return m_player; }
    [[nodiscard]] Viewport& viewport() { return *m_viewport; }
    [[nodiscard]] NoisePane& noisePane() { return m_docks.noisePane(); }
    [[nodiscard]] Docks& docks() { return m_docks; }
    [[nodiscard]] Recovery& recovery() { return m_recovery; }
    [[nodiscard]] DocumentFiles& files() { return m_files; }
    [[nodiscard]] ActionSet& actions() { return m_actions; }
    [[nodiscard]] ExportController& exports() { return m_exports; }
    /// What stays until it is answered.
    [[nodiscard]] MessageBar& messages() { return *m_messages; }
    [[nodiscard]] FileNotices& notices() { return m_notices; }

    /// Says something that is of interest now, and of this document.
    void notify(const QString& message);
    /// What a session without files shows first.
    void begin();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void buildCentre();
    void buildMenus();
    void connectFileActions();
    void connectWindowActions();
    void connectViews();
    void connectPresets();
    void connectLayers();
    void connectMemory();
    void connectExports();
    void connectStatus();
    StartDialog* showStart();
    void startTour();
    void showPreferences();
    void showSmokeOnly(bool only);
    void searchCommands();
    void showTitle();

    AppServices& m_services;

    // Each member comes after those that it looks at, and so is gone before them. Qt would delete widgets and dialogs
    // as children of the window too, but only when its members are gone: hence whoever looks at document or player is
    // owned here.
    Document m_document;
    Solo m_solo;
    Player m_player;
    Locks m_locks;
    ActionSet m_actions;
    DocumentFiles m_files;
    Recovery m_recovery;
    MessageBar* m_messages; ///< a child of the window
    FileNotices m_notices;
    std::unique_ptr<Viewport> m_viewport;
    std::unique_ptr<TimelineBar> m_timeline;
    Docks m_docks;
    EditActions m_editActions;
    ViewActions m_viewActions;
    Comparison m_comparison;
    ExportController m_exports;
    DropHandler m_drops;
    QShortcut* m_leaveSmokeOnly = nullptr; ///< a child of the window
    /// Context of what this window hears from the members above: dying, they speak once more, to a window that is half
    /// gone by then.
    QObject m_connectionContext;
};

} // namespace fumage::ui
