#include "ui/shell/preferences.h"

#include "ui/theme/language.h"
#include "ui/shell/menus.h"
#include "ui/shell/app_services.h"
#include "ui/presets/thumbnail_store.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

/// A list of which one thing is always chosen.
QComboBox* addList(QFormLayout& form, const QString& name, const QString& label, const QStringList& choices, int chosen,
    const std::function<void(int)>& choose)
{
    auto* list = new QComboBox(form.parentWidget());
    list->setObjectName(name);
    list->setAccessibleName(label);
    list->addItems(choices);
    list->setCurrentIndex(chosen);
    QObject::connect(list, &QComboBox::activated, list, choose);
    form.addRow(label, list);
    return list;
}

/// A whole number.
QSpinBox* addNumber(QFormLayout& form, const QString& name, const QString& label, int least, int most, int value)
{
    auto* box = new QSpinBox(form.parentWidget());
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setRange(least, most);
    box->setKeyboardTracking(false);
    box->setValue(value);
    form.addRow(label, box);
    return box;
}

/// A button that shows a folder, which is made where there is none yet.
QPushButton* makeFolderButton(const QString& name, const QString& path, QWidget* parent)
{
    auto* button = new QPushButton(Preferences::tr("Show the folder"), parent);
    button->setObjectName(name);
    button->setAutoDefault(false);
    QObject::connect(button, &QPushButton::clicked, parent, [path] {
        QDir().mkpath(path);
        QDesktopServices::openUrl(QUrl::fromLocalFile(path));
    });
    return button;
}

/// What there is to know of the row above.
void addRemark(QFormLayout& form, const QString& text)
{
    auto* label = new QLabel(text, form.parentWidget());
    label->setProperty("role", QStringLiteral("secondary"));
    label->setWordWrap(true);
    form.addRow(QString(), label);
}

} // namespace

Preferences::Preferences(AppServices& services, QWidget* parent)
    : QDialog(parent)
    , m_services(services)
    , m_cacheSize(new QLabel(this))
{
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    layout->addLayout(form);
    addFace(*form);
    addViewport(*form);
    addMachine(*form);
    addCache(*form);
    addStart(*form);
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    close->setObjectName(QStringLiteral("preferences.close"));
    close->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    layout->addStretch();
    layout->addWidget(buttons);
    constexpr int kWidth = 520;
    setMinimumWidth(kWidth);
}

void Preferences::addFace(QFormLayout& form)
{
    Settings& settings = m_services.settings();
    addList(form, QStringLiteral("preferences.theme"), tr("Theme"), themeNames(), static_cast<int>(settings.theme()),
        [this](int index) { m_services.applyTheme(static_cast<Theme>(index)); });
    addList(form, QStringLiteral("preferences.language"), tr("Language"), languageNames(), languageIndex(settings),
        [&settings](int index) { setLanguage(settings, index); });
    addRemark(form, tr("The language changes when Fumage starts the next time."));
}

void Preferences::addViewport(QFormLayout& form)
{
    Settings& settings = m_services.settings();
    addList(form, QStringLiteral("preferences.navigation"), tr("Mouse in the viewport"), navigationNames(),
        static_cast<int>(settings.navigationStyle()),
        [&settings](int index) { settings.setNavigationStyle(static_cast<NavigationStyle>(index)); });
    addList(form, QStringLiteral("preferences.openGl"), tr("OpenGL"),
        {tr("Where there is a graphics card"), tr("Always"), tr("Never")}, static_cast<int>(settings.openGl()),
        [&settings](int index) { settings.setOpenGl(static_cast<OpenGlChoice>(index)); });
    addRemark(form,
        tr("“Never” helps where the picture is black or torn. It takes effect when Fumage starts the next time."));
    QSpinBox* megabytes = addNumber(form, QStringLiteral("preferences.memory"), tr("Memory for pictures"),
        Settings::kMinPictureMegabytes, Settings::kMaxPictureMegabytes, settings.pictureMegabytes());
    megabytes->setSuffix(tr(" MB"));
    connect(megabytes, &QSpinBox::valueChanged, &settings, &Settings::setPictureMegabytes);
    addRemark(form, tr("Frames that a window keeps to play them again at once. Simulation and air come on top."));
}

void Preferences::addMachine(QFormLayout& form)
{
    Settings& settings = m_services.settings();
    QSpinBox* threads = addNumber(
        form, QStringLiteral("preferences.threads"), tr("Threads"), 0, Settings::kMaxThreads, settings.threads());
    threads->setSpecialValueText(tr("All (%1)").arg(m_services.allThreads()));
    connect(threads, &QSpinBox::valueChanged, &settings, &Settings::setThreads);
    addRemark(form, tr("Fewer leave more of the processor to other programs. Results are the same."));
}

void Preferences::addCache(QFormLayout& form)
{
    Settings& settings = m_services.settings();
    const QString folder = ThumbnailStore::usualFolder().path();
    QSpinBox* most = addNumber(form, QStringLiteral("preferences.cache"), tr("Thumbnails on the disk"),
        Settings::kMinCacheMegabytes, Settings::kMaxCacheMegabytes, settings.cacheMegabytes());
    most->setSuffix(tr(" MB at most"));
    connect(most, &QSpinBox::valueChanged, &settings, &Settings::setCacheMegabytes);
    auto* clear = new QPushButton(tr("Clear"), this);
    clear->setObjectName(QStringLiteral("preferences.clearCache"));
    clear->setAutoDefault(false);
    connect(clear, &QPushButton::clicked, this, [this] { measureCache(true); });
    m_cacheSize->setObjectName(QStringLiteral("preferences.cacheSize"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_cacheSize, 1);
    row->addWidget(clear);
    row->addWidget(makeFolderButton(QStringLiteral("preferences.cacheFolder"), folder, this));
    form.addRow(QString(), row);
    addRemark(form, QDir::toNativeSeparators(folder));
    measureCache(false);
}

void Preferences::measureCache(bool clears)
{
    m_cache.ask(
        [this, clears](const AsyncRequest::Report& report, const std::stop_token&) {
            const ThumbnailStore store(ThumbnailStore::usualFolder());
            if (clears) {
                store.clear();
            }
            const qint64 bytes = store.size();
            report([this, bytes] { m_cacheSize->setText(tr("%1 now").arg(locale().formattedDataSize(bytes, 1))); });
        },
        [](const Error&) {});
}

void Preferences::addStart(QFormLayout& form)
{
    Settings& settings = m_services.settings();
    auto* start = new QCheckBox(tr("Show presets when Fumage starts"), this);
    start->setObjectName(QStringLiteral("preferences.start"));
    start->setChecked(settings.showsStartDialog());
    connect(start, &QCheckBox::toggled, &settings, &Settings::setShowsStartDialog);
    form.addRow(tr("Start"), start);
    auto* plays = new QCheckBox(tr("Play thumbnails under the pointer"), this);
    plays->setObjectName(QStringLiteral("preferences.plays"));
    plays->setChecked(settings.playsThumbnails());
    connect(plays, &QCheckBox::toggled, &settings, &Settings::setPlaysThumbnails);
    form.addRow(tr("Motion"), plays);
    form.addRow(
        tr("Recovery"), makeFolderButton(QStringLiteral("preferences.recovery"), Settings::recoveryFolder(), this));
    addRemark(form,
        tr("A copy of unsaved work is kept a second after each change, and is opened again should the program end "
           "unexpectedly: %1")
            .arg(QDir::toNativeSeparators(Settings::recoveryFolder())));
}

} // namespace fumage::ui
