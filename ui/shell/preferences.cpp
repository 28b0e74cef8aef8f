#include "ui/shell/preferences.h"

#include "ui/theme/language.h"
#include "ui/shell/menus.h"
#include "ui/shell/app_services.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
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
    auto* megabytes = new QSpinBox(this);
    megabytes->setObjectName(QStringLiteral("preferences.memory"));
    megabytes->setAccessibleName(tr("Memory for pictures"));
    megabytes->setRange(Settings::kMinPictureMegabytes, Settings::kMaxPictureMegabytes);
    megabytes->setSuffix(tr(" MB"));
    megabytes->setKeyboardTracking(false);
    megabytes->setValue(settings.pictureMegabytes());
    connect(megabytes, &QSpinBox::valueChanged, &settings, &Settings::setPictureMegabytes);
    form.addRow(tr("Memory for pictures"), megabytes);
    addRemark(form, tr("Frames that a window keeps to play them again at once. Simulation and air come on top."));
}

void Preferences::addStart(QFormLayout& form)
{
    Settings& settings = m_services.settings();
    auto* start = new QCheckBox(tr("Show presets when Fumage starts"), this);
    start->setObjectName(QStringLiteral("preferences.start"));
    start->setChecked(settings.showsStartDialog());
    connect(start, &QCheckBox::toggled, &settings, &Settings::setShowsStartDialog);
    form.addRow(tr("Start"), start);
    auto* folder = new QPushButton(tr("Show the folder"), this);
    folder->setObjectName(QStringLiteral("preferences.recovery"));
    folder->setAutoDefault(false);
    connect(folder, &QPushButton::clicked, this, [] {
        QDir().mkpath(Settings::recoveryFolder());
        QDesktopServices::openUrl(QUrl::fromLocalFile(Settings::recoveryFolder()));
    });
    form.addRow(tr("Recovery"), folder);
    addRemark(form,
        tr("A copy of unsaved work is kept a second after each change, and is opened again should the program end "
           "unexpectedly: %1")
            .arg(QDir::toNativeSeparators(Settings::recoveryFolder())));
}

} // namespace fumage::ui
