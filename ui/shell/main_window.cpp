#include "ui/shell/main_window.h"

#include "ui/document/text.h"
#include "ui/export/export_dialog.h"
#include "ui/face/language.h"
#include "ui/noise_preview/noise_pane.h"
#include "ui/panels/colour_editor.h"
#include "ui/panels/effect_panel.h"
#include "ui/presets/preset_browser.h"
#include "ui/presets/start_dialog.h"
#include "ui/presets/variations_panel.h"
#include "ui/shell/command_search.h"
#include "ui/shell/help.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/viewport/viewport.h"

#include "core/effect/variation.h"

#include <cmath>

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QRandomGenerator>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoView>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

const QString kGeometry = QStringLiteral("window/geometry");
const QString kLayout = QStringLiteral("window/layout");
const QString kOpenGroups = QStringLiteral("panels/open");
const QString kOverlays = QStringLiteral("window/overlays");
constexpr int kLayoutVersion = 1;

struct OverlayAction {
    const char* action;
    Overlay overlay;
    bool remembered = true;
};
constexpr OverlayAction kOverlayActions[] = {
    {"view.grid", Overlay::Grid},
    {"view.emitter", Overlay::Emitter},
    {"view.gizmos", Overlay::Gizmos},
    {"view.tracks", Overlay::Tracks},
    {"view.frame", Overlay::Frame, false}, // comes and goes with the export dialog
    {"view.readout", Overlay::Readout},
};

/// A view from a side; straight up and down would leave no horizon.
struct Side {
    const char* action;
    float yaw;
    float pitch;
};
constexpr Side kSides[] = {
    {"view.front", 0.0F, 0.0F},
    {"view.right", 90.0F, 0.0F},
    {"view.back", 180.0F, 0.0F},
    {"view.left", -90.0F, 0.0F},
    {"view.top", 0.0F, 89.0F},
    {"view.bottom", 0.0F, -89.0F},
};

/// A key that is down for longer than this was held, not tapped.
constexpr qint64 kTapMs = 300;

} // namespace

MainWindow::MainWindow(Session& session)
    : m_session(session)
    , m_actions(this)
    , m_files(m_document, session.settings(), this)
    , m_recovery(m_document, QDir(Settings::recoveryFolder()))
{
    setObjectName(QStringLiteral("mainWindow"));
    setAttribute(Qt::WA_DeleteOnClose);
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);

    auto* centre = new QWidget(this);
    m_viewport = new Viewport(m_document, m_player, session.glSupport(), centre);
    m_timeline = new TimelineBar(m_document, m_player, centre);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_viewport, 1);
    layout->addWidget(m_timeline);
    setCentralWidget(centre);

    buildDocks();
    buildMenus();
    buildToolBar();
    connectFileActions();
    connectEditActions();
    connectViewActions();
    connectPlayActions();
    connectCompareActions();
    connectHelpActions();
    connectPresets();
    connectExport();
    m_viewport->setNavigationStyle(session.settings().navigationStyle());
    connect(m_viewport, &Viewport::cacheChanged, this, [this] { m_timeline->ruler().setCached(m_viewport->cachedFrames()); });
    connect(&m_document, &Document::titleChanged, this, &MainWindow::showTitle);
    connect(&m_document, &Document::loaded, this, &MainWindow::showTitle);
    connect(&m_recovery, &Recovery::failed, this, [this](const QString& message) { statusBar()->showMessage(tr("Unsaved work cannot be kept safe: %1").arg(message)); });
    statusBar()->setSizeGripEnabled(false);
    statusBar()->hide();
    connect(statusBar(), &QStatusBar::messageChanged, this, [this](const QString& message) { statusBar()->setVisible(!message.isEmpty()); });
    showTitle();
    restoreLayout();
    m_player.play();
}

MainWindow::~MainWindow()
{
    if (QWidget* typing = focusWidget()) {
        typing->clearFocus();
    }
    // The parts look at document and player, which are members and would be gone before them.
    disconnect(m_document.undoStack(), nullptr, this, nullptr);
    disconnect(&m_document, nullptr, this, nullptr);
    delete m_exportDialog;
    delete m_exportJob;
    qDeleteAll(m_docks);
    delete takeCentralWidget();
}

// --- parts ---------------------------------------------------------------------------------------------------------------

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    addDockWidget(area, dock);
    m_docks.insert(name, dock);
    // The tab of a tabbed panel says its name: a bar with the same name below it would say it twice.
    const auto followTabs = [this, dock] {
        const bool tabbed = !dock->isFloating() && !tabifiedDockWidgets(dock).isEmpty();
        if (tabbed != (dock->titleBarWidget() != nullptr)) {
            QWidget* old = dock->titleBarWidget();
            dock->setTitleBarWidget(tabbed ? new QWidget(dock) : nullptr);
            delete old;
        }
    };
    connect(dock, &QDockWidget::visibilityChanged, this, followTabs, Qt::QueuedConnection);
    connect(dock, &QDockWidget::topLevelChanged, this, followTabs, Qt::QueuedConnection);
    connect(dock, &QDockWidget::dockLocationChanged, this, followTabs, Qt::QueuedConnection);
    return dock;
}

void MainWindow::buildDocks()
{
    m_effectPanel = new EffectPanel(m_document, m_locks);
    m_noisePane = new NoisePane(m_document);
    auto* history = new QUndoView(m_document.undoStack());
    history->setObjectName(QStringLiteral("historyView"));
    history->setEmptyLabel(tr("As opened"));
    history->setAccessibleName(tr("Undo history"));
    m_browser = new PresetBrowser;
    m_variations = new VariationsPanel(m_document, m_locks);
    addDock(QStringLiteral("dock.presets"), tr("Presets"), m_browser, Qt::LeftDockWidgetArea);
    addDock(QStringLiteral("dock.parameters"), tr("Parameters"), m_effectPanel, Qt::RightDockWidgetArea);
    addDock(QStringLiteral("dock.noise"), tr("Noise"), m_noisePane, Qt::LeftDockWidgetArea);
    addDock(QStringLiteral("dock.history"), tr("History"), history, Qt::RightDockWidgetArea);
    addDock(QStringLiteral("dock.variations"), tr("Variations"), m_variations, Qt::RightDockWidgetArea);
    arrangeDocks();
}

void MainWindow::arrangeDocks()
{
    QDockWidget* presets = m_docks.value(QStringLiteral("dock.presets"));
    QDockWidget* noise = m_docks.value(QStringLiteral("dock.noise"));
    QDockWidget* parameters = m_docks.value(QStringLiteral("dock.parameters"));
    QDockWidget* variations = m_docks.value(QStringLiteral("dock.variations"));
    QDockWidget* history = m_docks.value(QStringLiteral("dock.history"));
    for (QDockWidget* dock : std::as_const(m_docks)) {
        dock->setFloating(false);
        dock->show();
    }
    addDockWidget(Qt::LeftDockWidgetArea, presets);
    addDockWidget(Qt::LeftDockWidgetArea, noise);
    splitDockWidget(presets, noise, Qt::Vertical);
    addDockWidget(Qt::RightDockWidgetArea, parameters);
    tabifyDockWidget(parameters, variations);
    tabifyDockWidget(variations, history);
    parameters->raise();
    constexpr int kLeft = 316;
    constexpr int kRight = 376;
    resizeDocks({presets, parameters}, {kLeft, kRight}, Qt::Horizontal);
    constexpr int kNoise = 470;
    resizeDocks({presets, noise}, {std::max(kNoise / 2, height() - kNoise), kNoise}, Qt::Vertical);
}

void MainWindow::raiseDock(const QString& name)
{
    m_docks.value(name)->show();
    m_docks.value(name)->raise();
}

void MainWindow::buildMenus()
{
    QHash<QString, QMenu*> menus;
    for (const ActionSpec& spec : actionSpecs()) {
        QMenu*& menu = menus[QLatin1String(spec.menu)];
        if (menu == nullptr) {
            menu = menuBar()->addMenu(actionText(spec.menu));
            menu->setToolTipsVisible(true);
        }
        if (spec.beginsSection) {
            menu->addSeparator();
        }
        menu->addAction(&m_actions.get(spec.id));
        if (QLatin1String(spec.id) == QLatin1String("file.open")) {
            m_recentMenu = menu->addMenu(tr("Open &recent"));
            m_recentMenu->setObjectName(QStringLiteral("recentMenu"));
        }
        if (QLatin1String(spec.id) == QLatin1String("view.backdrop")) {
            addChoices(*menu);
        }
    }
    rebuildRecentFiles();
    connect(&m_session.settings(), &Settings::recentFilesChanged, this, &MainWindow::rebuildRecentFiles);
}

void MainWindow::addChoices(QMenu& menu)
{
    menu.addSeparator();
    QMenu* panels = menu.addMenu(tr("&Panels"));
    for (QDockWidget* dock : findChildren<QDockWidget*>()) {
        panels->addAction(dock->toggleViewAction());
    }
    const auto addGroup = [&](QMenu& parent, const QStringList& names, int current, auto&& chosen) {
        auto* group = new QActionGroup(&parent);
        for (int i = 0; i < names.size(); ++i) {
            QAction* action = parent.addAction(names[i]);
            action->setCheckable(true);
            action->setChecked(i == current);
            group->addAction(action);
            connect(action, &QAction::triggered, this, [chosen, i] { chosen(i); });
        }
    };
    QMenu* navigation = menu.addMenu(tr("&Mouse habits"));
    addGroup(*navigation, {QStringLiteral("Blender"), QStringLiteral("Maya"), QStringLiteral("Unity")}, static_cast<int>(m_session.settings().navigationStyle()), [this](int index) {
        m_session.settings().setNavigationStyle(static_cast<NavigationStyle>(index));
        m_viewport->setNavigationStyle(static_cast<NavigationStyle>(index));
    });
    QStringList names{tr("As the system")};
    int spoken = 0;
    for (const Language& language : languages()) {
        spoken = language.code == m_session.settings().language() ? static_cast<int>(names.size()) : spoken;
        names += language.name;
    }
    QMenu* speech = menu.addMenu(tr("Lan&guage"));
    addGroup(*speech, names, spoken, [this](int index) {
        m_session.settings().setLanguage(index == 0 ? QString() : languages()[index - 1].code);
        notify(tr("The language changes when Fumage starts the next time."));
    });
    QMenu* theme = menu.addMenu(tr("T&heme"));
    addGroup(*theme, {tr("As the desktop"), tr("Dark"), tr("Light")}, static_cast<int>(m_session.settings().theme()), [this](int index) { m_session.applyTheme(static_cast<Theme>(index)); });
}

void MainWindow::buildToolBar()
{
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    const auto add = [&](std::initializer_list<const char*> ids) {
        for (const char* id : ids) {
            bar->addAction(&m_actions.get(id));
        }
    };
    add({"file.new", "file.open", "file.save"});
    bar->addSeparator();
    add({"edit.undo", "edit.redo"});
    bar->addSeparator();
    add({"edit.variations", "edit.randomise", "compare.split"});
    bar->addSeparator();
    add({"view.frameAll", "view.grid", "view.gizmos", "view.tracks", "view.frame", "view.checker"});
    auto* space = new QWidget(bar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    add({"file.export"});
}

void MainWindow::rebuildRecentFiles()
{
    m_recentMenu->clear();
    for (const QString& path : m_session.settings().recentFiles()) {
        QAction* action = m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { m_files.openFile(path); });
        action->setToolTip(path);
        action->setData(path);
    }
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
}

// --- actions -------------------------------------------------------------------------------------------------------------

void MainWindow::connectFileActions()
{
    m_actions.on("file.new", &m_files, &DocumentFiles::newDocument);
    m_actions.on("file.newWindow", this, [this] { m_session.openWindow(); });
    m_actions.on("file.open", &m_files, &DocumentFiles::open);
    m_actions.on("file.save", &m_files, &DocumentFiles::save);
    m_actions.on("file.saveAs", &m_files, &DocumentFiles::saveAs);
    m_actions.on("file.saveToLibrary", &m_files, &DocumentFiles::saveToLibrary);
    m_actions.on("file.revert", &m_files, &DocumentFiles::revert);
    m_actions.on("file.close", this, &QWidget::close);
    m_actions.on("file.quit", this, [this] { m_session.closeAll(); });
}

void MainWindow::connectEditActions()
{
    QUndoStack* stack = m_document.undoStack();
    const auto follow = [this, stack] {
        m_actions.get("edit.undo").setEnabled(stack->canUndo());
        m_actions.get("edit.redo").setEnabled(stack->canRedo());
        m_actions.get("edit.undo").setText(stack->canUndo() ? tr("&Undo %1").arg(stack->undoText()) : tr("&Undo"));
        m_actions.get("edit.redo").setText(stack->canRedo() ? tr("&Redo %1").arg(stack->redoText()) : tr("&Redo"));
    };
    connect(stack, &QUndoStack::indexChanged, this, follow);
    follow();
    m_actions.on("edit.undo", stack, &QUndoStack::undo);
    m_actions.on("edit.redo", stack, &QUndoStack::redo);
    m_actions.on("edit.copyPreset", &m_files, &DocumentFiles::copyPreset);
    m_actions.on("edit.pastePreset", &m_files, &DocumentFiles::pastePreset);
    m_actions.on("edit.randomise", this, [this] {
        constexpr float kALittle = 0.06F;
        const Effect varied = vary(m_document.effect(), kALittle, QRandomGenerator::global()->generate(), [this](const Parameter& p) { return isCharacter(p) && !m_locks.contains(p); });
        m_document.replaceEffect(varied, tr("Randomise a little"));
    });
    m_actions.on("edit.resetAll", this, [this] { m_document.replaceEffect(m_document.reference(), tr("Reset all parameters")); });
    m_actions.on("edit.variations", this, [this] { raiseDock(QStringLiteral("dock.variations")); });
    m_actions.on("edit.commands", this, [this] {
        auto* search = new CommandSearch(m_actions, this);
        search->setAttribute(Qt::WA_DeleteOnClose);
        connect(search, &CommandSearch::parameterChosen, this, [this](const QString& key) {
            raiseDock(QStringLiteral("dock.parameters"));
            m_effectPanel->showParameter(key);
        });
        search->show();
    });
    m_actions.on("edit.search", this, [this] {
        raiseDock(QStringLiteral("dock.parameters"));
        m_effectPanel->search();
    });
}

void MainWindow::connectViewActions()
{
    m_actions.on("view.frameAll", m_viewport, &Viewport::frameAll);
    for (const Side& side : kSides) {
        m_actions.on(side.action, this, [this, side] { m_viewport->lookFrom(side.yaw, side.pitch); });
    }
    for (const OverlayAction& entry : kOverlayActions) {
        QAction& action = m_actions.get(entry.action);
        action.setChecked(m_viewport->overlays().testFlag(entry.overlay));
        connect(&action, &QAction::toggled, this, [this, overlay = entry.overlay](bool on) { m_viewport->setOverlay(overlay, on); });
    }
    connect(&m_actions.get("view.checker"), &QAction::toggled, this, [this](bool on) {
        Backdrop backdrop = m_viewport->backdrop();
        backdrop.kind = on ? Backdrop::Kind::Checker : Backdrop::Kind::Colour;
        m_viewport->setBackdrop(backdrop);
    });
    m_actions.on("view.backdrop", this, [this] {
        chooseColour(this, tr("Backdrop"), m_viewport->backdrop().colour, [this](const glm::vec3& colour, bool) {
            m_viewport->setBackdrop({Backdrop::Kind::Colour, colour});
            m_actions.get("view.checker").setChecked(false);
        });
    });
    connect(&m_actions.get("view.fullScreen"), &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
    m_actions.on("view.resetLayout", this, &MainWindow::arrangeDocks);
}

void MainWindow::connectPlayActions()
{
    m_actions.on("play.toggle", &m_player, &Player::toggle);
    m_actions.on("play.forward", this, [this] { m_player.stepBy(1); });
    m_actions.on("play.back", this, [this] { m_player.stepBy(-1); });
    m_actions.on("play.start", &m_player, &Player::toStart);
    m_actions.on("play.end", &m_player, &Player::toEnd);
    m_actions.on("play.in", this, [this] { m_player.setRange(m_player.frame(), std::max(m_player.frame(), m_player.last())); });
    m_actions.on("play.out", this, [this] { m_player.setRange(std::min(m_player.frame(), m_player.first()), m_player.frame()); });
    m_actions.on("play.wholeRange", this, [this] { m_player.setRange(0, m_player.length() - 1); });
}

void MainWindow::compare(bool split, bool other)
{
    m_viewport->setCompare(other ? Viewport::Compare::Other : (split ? Viewport::Compare::Split : Viewport::Compare::Off), m_other);
}

void MainWindow::connectCompareActions()
{
    m_other = m_document.effect();
    QAction& split = m_actions.get("compare.split");
    QAction& hold = m_actions.get("compare.hold");
    const auto follow = [this, &split, &hold] { compare(split.isChecked(), hold.isChecked()); };
    m_actions.on("compare.remember", this, [this, follow] {
        m_other = m_document.effect();
        follow();
    });
    connect(&split, &QAction::toggled, this, follow);
    connect(&hold, &QAction::toggled, this, follow);
    hold.setAutoRepeat(false);
    connect(&hold, &QAction::triggered, this, [this](bool on) {
        if (on) {
            m_sinceB.start();
        }
    });
    // A tap of the key stays at B; a key that was held goes back when it is let go.
    qApp->installEventFilter(this);
    m_actions.on("compare.adopt", this, [this] { m_document.replaceEffect(m_other, tr("Adopt B")); });
    connect(&m_document, &Document::loaded, this, [this] { m_other = m_document.effect(); });
}

void MainWindow::connectHelpActions()
{
    m_actions.on("help.reference", this, [this] { showReference(this); });
    m_actions.on("help.shortcuts", this, [this] { showShortcuts(this); });
    m_actions.on("help.about", this, [this] { showAbout(this); });
}

void MainWindow::connectPresets()
{
    Settings& settings = m_session.settings();
    m_browser->setFavourites(settings.favourites());
    connect(m_browser, &PresetBrowser::opened, &m_files, &DocumentFiles::openPreset);
    connect(m_browser, &PresetBrowser::applied, this, [this](const Preset& preset) {
        m_document.replaceEffect(preset.effect, tr("Put in “%1”").arg(toQString(preset.name)));
    });
    connect(m_browser, &PresetBrowser::favouriteChanged, &settings, &Settings::setFavourite);
    connect(&settings, &Settings::favouritesChanged, m_browser, [this, &settings] { m_browser->setFavourites(settings.favourites()); });
    connect(&m_files, &DocumentFiles::libraryChanged, &m_browser->list(), &PresetList::reload);
}

void MainWindow::connectExport()
{
    m_exportJob = new ExportJob(this);
    const auto dialog = [this]() -> ExportDialog& {
        if (m_exportDialog == nullptr) {
            m_exportDialog = new ExportDialog(m_document, m_player, m_locks, *m_exportJob, this);
            connect(m_exportDialog, &ExportDialog::shownChanged, this, [this](bool shown) { m_actions.get("view.frame").setChecked(shown); });
        }
        m_exportDialog->show();
        m_exportDialog->raise();
        return *m_exportDialog;
    };
    m_actions.on("file.export", this, [dialog] { dialog(); });
    m_actions.on("file.exportAgain", this, [this, dialog] {
        if (m_exportJob->lastPlan()) {
            m_exportJob->start(m_document.effect(), *m_exportJob->lastPlan());
        } else {
            dialog();
        }
    });
    connect(m_noisePane, &NoisePane::exportRequested, this, [dialog] { dialog().setKind(ExportKind::NoiseTexture); });
    // The status bar tells those who have closed the dialog.
    connect(m_exportJob, &ExportJob::progressed, this, [this](int done, int total, double secondsLeft) {
        statusBar()->showMessage(tr("Exporting: %1 of %2 files, %3 s left").arg(done).arg(total).arg(std::ceil(secondsLeft)));
    });
    constexpr int kShownMs = 8000;
    connect(m_exportJob, &ExportJob::finished, this, [this](const QString& file) { statusBar()->showMessage(tr("Exported %1").arg(file), kShownMs); });
    connect(m_exportJob, &ExportJob::cancelled, this, [this] { statusBar()->showMessage(tr("Export cancelled"), kShownMs); });
    connect(m_exportJob, &ExportJob::failed, this, [this](const QString& message) { statusBar()->showMessage(tr("Export failed: %1").arg(message)); });
}

void MainWindow::notify(const QString& message)
{
    statusBar()->showMessage(message);
}

void MainWindow::begin()
{
    if (!m_session.settings().showsStartDialog()) {
        return;
    }
    auto* dialog = new StartDialog(m_session.settings().recentFiles(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &StartDialog::presetChosen, this, [this](const Preset& preset) { m_files.openPreset(preset); });
    connect(dialog, &StartDialog::fileChosen, this, [this](const QString& path) { m_files.openFile(path); });
    connect(dialog, &StartDialog::openRequested, &m_files, &DocumentFiles::open);
    connect(dialog, &QDialog::finished, this, [this, dialog] { m_session.settings().setShowsStartDialog(dialog->showAgain()); });
    dialog->open();
}

// --- window --------------------------------------------------------------------------------------------------------------

void MainWindow::showTitle()
{
    setWindowFilePath(m_document.filePath());
    setWindowTitle(QStringLiteral("%1[*] — Fumage").arg(m_document.displayName()));
    setWindowModified(m_document.isModified());
}

void MainWindow::restoreLayout()
{
    constexpr QSize kUsual(1440, 900);
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    resize(kUsual.boundedTo(screen.size()));
    // Qt moves a window whose screen is gone onto one that is there.
    restoreGeometry(m_session.settings().bytes(kGeometry));
    if (!restoreState(m_session.settings().bytes(kLayout), kLayoutVersion)) {
        // Panels can be given their sizes once the window has its own.
        QMetaObject::invokeMethod(this, &MainWindow::arrangeDocks, Qt::QueuedConnection);
    }
    m_effectPanel->setOpenGroups(m_session.settings().list(kOpenGroups, {QStringLiteral("emitter"), QStringLiteral("motion")}));
    const QStringList overlays = m_session.settings().list(kOverlays, shownOverlays());
    for (const OverlayAction& entry : kOverlayActions) {
        if (entry.remembered) {
            m_actions.get(entry.action).setChecked(overlays.contains(QLatin1String(entry.action)));
        }
    }
}

QStringList MainWindow::shownOverlays() const
{
    QStringList shown;
    for (const OverlayAction& entry : kOverlayActions) {
        if (entry.remembered && m_viewport->overlays().testFlag(entry.overlay)) {
            shown.append(QLatin1String(entry.action));
        }
    }
    return shown;
}

void MainWindow::saveLayout()
{
    m_session.settings().setBytes(kGeometry, saveGeometry());
    m_session.settings().setBytes(kLayout, saveState(kLayoutVersion));
    m_session.settings().setList(kOpenGroups, m_effectPanel->openGroups());
    m_session.settings().setList(kOverlays, shownOverlays());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files.mayLeave()) {
        event->ignore();
        return;
    }
    saveLayout();
    m_recovery.discard();
    event->accept();
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyRelease && m_sinceB.isValid()) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (key.key() == Qt::Key_B && !key.isAutoRepeat()) {
            if (m_sinceB.elapsed() > kTapMs) {
                m_actions.get("compare.hold").setChecked(false);
            }
            m_sinceB.invalidate();
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    const bool isFile = !urls.isEmpty() && urls.constFirst().isLocalFile();
    if (isFile || event->mimeData()->hasFormat(PresetList::mimeType())) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    const QString id = QString::fromUtf8(event->mimeData()->data(PresetList::mimeType()));
    if (const Preset* preset = m_browser->list().presetOfId(id)) {
        QMetaObject::invokeMethod(
            this, [this, copy = *preset] { m_files.openPreset(copy); }, Qt::QueuedConnection);
        return;
    }
    // The question about unsaved changes must not hold the program that the file comes from.
    const QString path = event->mimeData()->urls().constFirst().toLocalFile();
    QMetaObject::invokeMethod(
        this, [this, path] { m_files.openFile(path); }, Qt::QueuedConnection);
}

} // namespace fumage::ui
