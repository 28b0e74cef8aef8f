#include "ui/shell/main_window.h"

#include "ui/document/layer_edits.h"
#include "ui/document/text.h"
#include "ui/help/manual.h"
#include "ui/export/export_dialog.h"
#include "ui/export/queue_panel.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/plain_text.h"
#include "ui/noise_preview/noise_pane.h"
#include "ui/panels/effect_panel.h"
#include "ui/panels/layer_list.h"
#include "ui/presets/preset_browser.h"
#include "ui/presets/start_dialog.h"
#include "ui/shell/command_search.h"
#include "ui/shell/help.h"
#include "ui/shell/layer_actions.h"
#include "ui/shell/menus.h"
#include "ui/shell/play_actions.h"
#include "ui/shell/preferences.h"
#include "ui/shell/window_layout.h"
#include "ui/shell/window_tour.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

/// The widget that has the keyboard, if it belongs to a window: in a panel that floats it has another window() than
/// that.
QWidget* focusOf(const QWidget& window)
{
    QWidget* focus = QApplication::focusWidget();
    const QWidget* ancestor = focus;
    while (ancestor != nullptr && ancestor != &window) {
        ancestor = ancestor->parentWidget();
    }
    return ancestor != nullptr ? focus : nullptr;
}

} // namespace

MainWindow::MainWindow(AppServices& services)
    : m_services(services)
    , m_document(newPreset())
    , m_solo(m_document)
    , m_actions(this)
    , m_files(m_document, services.settings(), services.askForFile(), services.askForChoice(), this)
    , m_recovery(m_document, QDir(Settings::recoveryFolder()))
    , m_messages(new MessageBar(this))
    , m_notices(m_document, m_files, *m_messages)
    , m_viewport(std::make_unique<Viewport>(m_document, m_solo, m_player, services.shelf(), services.glSupport()))
    , m_timeline(std::make_unique<TimelineBar>(m_document, m_player))
    , m_docks(*this, m_document, m_locks, m_solo, services.exports(), services.askForFile())
    , m_editActions(m_actions, m_document, m_locks)
    , m_viewActions(m_actions, m_document, *m_viewport, *this)
    , m_comparison(m_document, *m_viewport, m_actions)
    , m_exports(services.exports(), m_document, m_solo, m_player, m_locks, m_actions, services.askForFile(),
          services.askForChoice(), services.settings(), this)
    , m_drops(*this, m_files, m_docks.browser().list())
{
    setObjectName(QStringLiteral("mainWindow"));
    setAttribute(Qt::WA_DeleteOnClose);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    buildCentre();
    buildMenus();
    connectFileActions();
    connectPlayActions(m_actions, m_player);
    connectKeyActions(m_actions, m_player, m_document);
    connectMarkerActions(m_actions, m_player, m_document);
    connectGraphAction(m_actions, *m_timeline, services.settings());
    connectWindowActions();
    connectViews();
    connectPresets();
    connectLayers();
    connectMemory();
    connectExports();
    connectStatus();
    connect(&m_document, &Document::titleChanged, &m_connectionContext, [this] { showTitle(); });
    connect(&m_document, &Document::loaded, &m_connectionContext, [this] { showTitle(); });
    showTitle();
    restoreLayout(*this, m_docks, m_viewActions, services.settings());
    centralWidget()->setFocus(); // or the first field would have it, and take Space for text
    m_player.play();
}

MainWindow::~MainWindow()
{
    // A field hands over what was typed when it loses the focus, at the latest while it is torn down: all who hear of
    // it must be there still.
    if (QWidget* field = focusOf(*this)) {
        field->clearFocus();
    }
}

// --- parts ---

void MainWindow::buildCentre()
{
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_viewport.get(), 1);
    layout->addWidget(m_timeline.get());
    centre->setFocusProxy(m_viewport->surface());
    setCentralWidget(centre);
    m_viewport->setNavigationStyle(m_services.settings().navigationStyle());
    connect(m_viewport.get(), &Viewport::baking, &m_timeline->ruler(), &TimelineRuler::setBaking);
    connect(m_viewport.get(), &Viewport::cacheChanged, m_timeline.get(),
        [this] { m_timeline->ruler().setCached(m_viewport->cachedFrames()); });
}

void MainWindow::buildMenus()
{
    buildMenuBar(*menuBar(), m_actions);
    buildToolBar(*this, m_actions);
    fillRecentFiles(m_actions.submenu("file.recent"), m_services.settings(), m_files);
    m_docks.fillMenu(m_actions.submenu("view.panels"));
    fillMouseHabits(m_actions.submenu("view.mouseHabits"), m_services.settings(), *m_viewport);
    fillLanguages(
        m_actions.submenu("view.language"), m_services.settings(), [this](const QString& message) { notify(message); });
    fillThemes(m_actions.submenu("view.theme"), m_services);
}

// --- connections ---

void MainWindow::connectFileActions()
{
    m_actions.on("file.new", &m_files, &DocumentFiles::newDocument);
    m_actions.on("file.start", this, &MainWindow::showStart);
    m_actions.on("file.newWindow", this, [this] { m_services.addWindow(); });
    m_actions.on("file.open", &m_files, &DocumentFiles::open);
    m_actions.on("file.save", &m_files, &DocumentFiles::save);
    m_actions.on("file.saveAs", &m_files, &DocumentFiles::saveAs);
    m_actions.on("file.saveToLibrary", &m_files, &DocumentFiles::saveToLibrary);
    m_actions.on("file.revert", &m_files, &DocumentFiles::revert);
    m_actions.on("file.close", this, &QWidget::close);
    m_actions.on("file.quit", &m_services, &AppServices::closeAll);
    m_actions.on("edit.copyPreset", &m_files, &DocumentFiles::copyPreset);
    m_actions.on("edit.pastePreset", &m_files, &DocumentFiles::pastePreset);
    connect(&m_files, &DocumentFiles::pictureOpened, &m_player, [this](int frame) {
        m_player.pause();
        m_player.setFrame(frame);
    });
}

void MainWindow::connectWindowActions()
{
    m_actions.on("edit.variations", &m_docks, &Docks::showVariations);
    m_actions.on("edit.search", &m_docks, &Docks::searchParameters);
    m_actions.on("edit.commands", this, &MainWindow::searchCommands);
    m_actions.on("edit.preferences", this, &MainWindow::showPreferences);
    connect(&m_actions.get("view.smokeOnly"), &QAction::toggled, &m_connectionContext,
        [this](bool on) { showSmokeOnly(on); });
    m_actions.on("view.resetLayout", this, [this] {
        m_actions.get("view.smokeOnly").setChecked(false);
        m_docks.arrange();
    });
    m_actions.on("help.manual", this,
        [this] { showManual(this, m_services.settings(), manualFolders(), referenceAnchorAtHand()); });
    m_actions.on("help.tour", this, [this] { startTour(); });
    m_actions.on("help.shortcuts", this, [this] { showShortcuts(this); });
    m_actions.on("help.about", this, [this] { showAbout(this); });
}

/// The menu bar goes, too: Escape leads back.
void MainWindow::showSmokeOnly(bool only)
{
    m_docks.setAllHidden(only);
    findChild<QToolBar*>(QStringLiteral("toolBar"))->setVisible(!only);
    m_timeline->setVisible(!only);
    menuBar()->setVisible(!only);
    statusBar()->setVisible(!only);
    m_messages->setAllHidden(only);
    m_viewport->setBare(only);
    m_leaveSmokeOnly->setEnabled(only);
}

void MainWindow::connectViews()
{
    m_leaveSmokeOnly = new QShortcut(Qt::Key_Escape, this, &m_actions.get("view.smokeOnly"), &QAction::toggle);
    m_leaveSmokeOnly->setEnabled(false);
    m_actions.on("view.previous", &m_document, &Document::previousView);
    m_actions.on("view.next", &m_document, &Document::nextView);
    const auto follow = [this] {
        m_actions.get("view.previous").setEnabled(m_document.views().hasPrevious());
        m_actions.get("view.next").setEnabled(m_document.views().hasNext());
    };
    connect(&m_document, &Document::viewsChanged, &m_connectionContext, follow);
    follow();
}

void MainWindow::connectMemory()
{
    Settings& settings = m_services.settings();
    constexpr qint64 kMegabyte = 1024 * 1024;
    const auto follow = [this](int megabytes) { m_viewport->setCacheBytes(megabytes * kMegabyte); };
    connect(&settings, &Settings::pictureMegabytesChanged, &m_connectionContext, follow);
    follow(settings.pictureMegabytes());
    connect(&m_document, &Document::loaded, &m_services, &AppServices::giveBackMemorySoon);
    connect(m_viewport.get(), &Viewport::dropped, &m_services, &AppServices::giveBackMemorySoon);
}

void MainWindow::connectPresets()
{
    Settings& settings = m_services.settings();
    PresetBrowser& browser = m_docks.browser();
    browser.setFavourites(settings.favourites());
    browser.list().setPlays(settings.playsThumbnails());
    connect(&settings, &Settings::playsThumbnailsChanged, &browser.list(), &PresetList::setPlays);
    connect(&browser, &PresetBrowser::opened, &m_files, &DocumentFiles::openPreset);
    connect(&browser, &PresetBrowser::applied, &m_document, [this](const Preset& preset) {
        m_document.replaceScene(preset.scene, 0, tr("Apply “%1”").arg(shortened(toQString(preset.name))));
    });
    connect(&browser, &PresetBrowser::layersWanted, &m_document,
        [this](const Preset& preset) { addLayersOf(m_document, preset, toQString(preset.name)); });
    connect(&browser, &PresetBrowser::favouriteChanged, &settings, &Settings::setFavourite);
    connect(&settings, &Settings::favouritesChanged, &browser,
        [&browser, &settings] { browser.setFavourites(settings.favourites()); });
    connect(&m_files, &DocumentFiles::libraryChanged, &browser.list(), &PresetList::reload);
}

void MainWindow::connectLayers()
{
    LayerList& list = m_docks.effectPanel().layers();
    new LayerActions(m_actions, m_document, m_solo, list); // a child of the list
    connect(m_viewport.get(), &Viewport::pictureShown, &list, [this, &list](const PicturePtr& picture) {
        std::vector<double> steps(m_document.scene().layers.size(), 0.0);
        for (const LayerWork& work : picture->layers) {
            if (work.layer < steps.size()) {
                steps[work.layer] = work.particleSteps;
            }
        }
        list.view().layers().noteWork(steps);
    });
    connect(&list.transfer(), &LayerTransfer::news, &m_connectionContext,
        [this](const QString& message) { notify(message); });
    connect(&list.transfer(), &LayerTransfer::refused, &m_connectionContext,
        [this](const QString& title, const QString& text) {
            m_messages->say(QStringLiteral("message.layers"), tr("%1: %2").arg(title, text), {{tr("OK"), {}}});
        });
}

void MainWindow::connectExports()
{
    connect(&m_docks.noisePane(), &NoisePane::exportRequested, &m_exports,
        [this] { m_exports.openDialog().setKind(ExportKind::NoiseTexture); });
    connect(&m_docks.queuePanel(), &QueuePanel::againRequested, &m_exports, &ExportController::exportAgain);
    connect(&m_docks.queuePanel(), &QueuePanel::failed, &m_connectionContext,
        [this](const QString& message) { notify(message); });
    connect(&m_exports, &ExportController::added, &m_docks, [this] {
        // The panel comes by itself once, behind the one that is there; where it is then is up to the user.
        if (!m_services.settings().hasSeenQueue()) {
            m_services.settings().setKnowsQueue(true);
            m_docks.addQueue();
        }
    });
}

void MainWindow::connectStatus()
{
    // What was said was said of another document.
    connect(&m_document, &Document::loaded, statusBar(), &QStatusBar::clearMessage);
    statusBar()->setSizeGripEnabled(false); // always there: if it came and went, the smoke would jump
    connect(&m_exports, &ExportController::news, statusBar(), &QStatusBar::showMessage);
    connect(&m_viewActions.cameraFit(), &CameraFit::news, statusBar(), &QStatusBar::showMessage);
    connect(&m_recovery, &Recovery::failed, &m_connectionContext,
        [this](const QString& message) { notify(tr("Unsaved work cannot be kept safe: %1").arg(message)); });
    connect(m_viewport.get(), &Viewport::pictureShown, &m_recovery, &Recovery::markRecovered);
    connect(m_viewport.get(), &Viewport::failed, &m_connectionContext, [this](const QString& why) { notify(why); });
    connect(m_viewport.get(), &Viewport::exhausted, &m_connectionContext, [this] {
        notify(tr("There is not enough memory for this picture. Use fewer particles or a smaller window."));
    });
}

void MainWindow::searchCommands()
{
    auto* search = new CommandSearch(m_actions, this);
    search->setAttribute(Qt::WA_DeleteOnClose);
    connect(search, &CommandSearch::parameterChosen, &m_docks, &Docks::showParameter);
    connect(search, &CommandSearch::presetChosen, &m_files, &DocumentFiles::openEntry);
    search->show();
}

void MainWindow::notify(const QString& message)
{
    statusBar()->showMessage(message);
}

void MainWindow::begin()
{
    const bool isFirstUse = m_services.settings().isFirstUse();
    if (!m_services.settings().showsStartDialog()) {
        return;
    }
    const StartDialog* start = showStart();
    if (isFirstUse) {
        connect(start, &QDialog::finished, this, &MainWindow::startTour, Qt::QueuedConnection);
    }
}

void MainWindow::startTour()
{
    m_services.settings().setTourSeen();
    if (startWindowTour(*this, m_actions) == nullptr) {
        notify(tr("There is nothing to be seen that the tour could show."));
    }
}

StartDialog* MainWindow::showStart()
{
    auto* dialog = new StartDialog(m_services.settings().recentFiles(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setShowAgain(m_services.settings().showsStartDialog());
    dialog->setPlays(m_services.settings().playsThumbnails());
    connect(dialog, &StartDialog::defaultRequested, &m_files, &DocumentFiles::newDocument);
    connect(dialog, &StartDialog::presetChosen, &m_files, &DocumentFiles::openPreset);
    connect(dialog, &StartDialog::fileChosen, &m_files, &DocumentFiles::openFile);
    connect(dialog, &StartDialog::openRequested, &m_files, &DocumentFiles::open);
    connect(dialog, &QDialog::finished, this,
        [this, dialog] { m_services.settings().setShowsStartDialog(dialog->showAgain()); });
    dialog->open();
    return dialog;
}

void MainWindow::showPreferences()
{
    auto* dialog = new Preferences(m_services, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

// --- window ---

void MainWindow::showTitle()
{
    setWindowFilePath(m_document.filePath());
    setWindowTitle(QStringLiteral("%1[*] — Fumage").arg(plainTitle(m_document.displayName())));
    setWindowModified(m_document.isModified());
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isActiveWindow()) {
        m_notices.look(); // people come back from where they have changed the file
    } else if (event->type() == QEvent::WindowStateChange && isMinimized()) {
        m_services.giveBackMemorySoon();
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    const bool isAsked = !m_services.isEnding();
    if (isAsked && m_exports.isBusy()) {
        // An export that was asked for is about to be in the queue: only then can it be asked what becomes of it.
        connect(&m_exports, &ExportController::rested, this, &QWidget::close,
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection | Qt::UniqueConnection));
        event->ignore();
        return;
    }
    if (isAsked && (!m_files.confirmDiscard() || !m_services.mayClose(*this))) {
        event->ignore();
        return;
    }
    m_actions.get("view.smokeOnly").setChecked(false); // is not remembered
    saveLayout(*this, m_docks, m_viewActions, m_services.settings());
    if (isAsked) {
        m_recovery.discard();
    }
    event->accept();
}

} // namespace fumage::ui
