#include "ui/presets/start_dialog.h"

#include "ui/document/text.h"
#include "ui/presets/scene_card.h"
#include "ui/widgets/plain_text.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kThumbnail = 128;
constexpr int kRecentWidth = 184;

/// What stands on top and moves at once, and what follows: scenes of several layers before all else.
const QString kBest = QStringLiteral("bonfire");
const QStringList kScenes{QStringLiteral("blast"), QStringLiteral("torch"), QStringLiteral("firework"),
    QStringLiteral("rocket-launch"), QStringLiteral("spell"), QStringLiteral("campfire"), QStringLiteral("explosion"),
    QStringLiteral("volcano")};

/// One click is enough, on desktops too that ask for two; where one activates anyway, it is no second time.
void activateByOneClick(QListWidget& list)
{
    QObject::connect(&list, &QListWidget::itemClicked, &list, [&list](QListWidgetItem* item) {
        if (list.style()->styleHint(QStyle::SH_ItemView_ActivateItemOnSingleClick, nullptr, &list) == 0) {
            emit list.itemActivated(item);
        }
    });
}

/// The files of last time, by their names.
QListWidget* makeRecent(const QStringList& paths, QWidget* parent)
{
    auto* files = new QListWidget(parent);
    files->setObjectName(QStringLiteral("startRecent"));
    files->setAccessibleName(StartDialog::tr("Recent files"));
    for (const QString& path : paths) {
        auto* item = new QListWidgetItem(onOneLine(nameOfFile(path)), files);
        item->setToolTip(plainToolTip(path));
        item->setData(Qt::UserRole, path);
    }
    if (paths.isEmpty()) {
        auto* hint = new QListWidgetItem(StartDialog::tr("Files that you open or save will be here"), files);
        hint->setFlags(Qt::NoItemFlags);
    }
    files->setWordWrap(true);
    files->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    files->setFixedWidth(kRecentWidth);
    return files;
}

QLabel* makeTitle(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setProperty("role", QStringLiteral("title"));
    return label;
}

} // namespace

StartDialog::StartDialog(const QStringList& recentFiles, QWidget* parent)
    : QDialog(parent)
    , m_list(new PresetList(kThumbnail, this))
    , m_card(new SceneCard(this))
    , m_again(new QCheckBox(tr("Show this when Fumage starts"), this))
{
    setObjectName(QStringLiteral("startDialog"));
    setWindowTitle(tr("Start from a preset"));
    m_list->setFirst(kScenes);
    QListWidget* files = makeRecent(recentFiles, this);
    auto* open = new QPushButton(tr("Open a file…"), this);
    open->setObjectName(QStringLiteral("startOpen"));
    auto* empty = new QPushButton(tr("New smoke"), this);
    empty->setObjectName(QStringLiteral("startDefault"));
    empty->setDefault(true);
    empty->setFocus();
    m_again->setObjectName(QStringLiteral("startAgain"));
    m_again->setChecked(true);

    auto* left = new QVBoxLayout;
    left->addWidget(m_card);
    left->addWidget(makeTitle(tr("Scenes and presets"), this));
    left->addWidget(m_list, 1);
    auto* right = new QVBoxLayout;
    right->addWidget(makeTitle(tr("Recent files"), this));
    right->addWidget(files, 1);
    right->addWidget(open);
    right->addWidget(empty);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(16);
    columns->addLayout(left, 1);
    columns->addLayout(right);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addLayout(columns, 1);
    layout->addWidget(m_again);
    constexpr QSize kUsual(984, 720); // five pictures side by side
    resize(kUsual);

    connectScenes();
    connect(files, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        if ((item->flags() & Qt::ItemIsEnabled) == 0) {
            return; // it is a word in place of files
        }
        accept();
        emit fileChosen(item->data(Qt::UserRole).toString());
    });
    activateByOneClick(*files);
    connect(open, &QPushButton::clicked, this, [this] {
        accept();
        emit openRequested();
    });
    connect(empty, &QPushButton::clicked, this, [this] {
        accept();
        emit defaultRequested();
    });
}

void StartDialog::connectScenes()
{
    connect(m_list, &PresetList::chosen, this, &StartDialog::choose);
    connect(m_list, &PresetList::presetRead, this, [this](const QString& id) {
        if (id == kBest) {
            const QListWidgetItem* item = m_list->itemOfId(id);
            m_card->setPreset(*m_list->presetOf(item), item->text(), m_list->descriptionOf(item));
        }
    });
    connect(m_card, &SceneCard::clicked, this, [this] {
        if (const Preset* preset = m_card->preset()) {
            choose(Preset(*preset)); // a copy: the card may go
        }
    });
    activateByOneClick(*m_list); // there is nothing else that one could want of a picture
}

void StartDialog::choose(const Preset& preset)
{
    accept();
    emit presetChosen(preset);
}

void StartDialog::setPlays(bool plays)
{
    m_list->setPlays(plays);
    m_card->setPlays(plays);
}

bool StartDialog::showAgain() const
{
    return m_again->isChecked();
}

void StartDialog::setShowAgain(bool shows)
{
    m_again->setChecked(shows);
}

} // namespace fumage::ui
