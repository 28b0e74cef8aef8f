#include "ui/export/pack_row.h"

#include "ui/document/text.h"
#include "ui/widgets/plain_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr std::array<int, 4> kDivisors{1, 2, 4, 8};

} // namespace

PackRow::PackRow(int number, QWidget* parent)
    : QWidget(parent)
    , m_name(new QLineEdit(QStringLiteral("masks%1").arg(number), this))
    , m_size(new QComboBox(this))
{
    const QString prefix = QStringLiteral("export.pack%1.").arg(number);
    m_name->setObjectName(prefix + QStringLiteral("name"));
    m_name->setAccessibleName(tr("Name of the packed picture"));
    m_name->setToolTip(tr("Stands behind the name of the sheet"));
    m_size->setObjectName(prefix + QStringLiteral("size"));
    m_size->setAccessibleName(tr("Size of the packed picture"));
    m_size->addItems({tr("Full size"), QStringLiteral("1/2"), QStringLiteral("1/4"), QStringLiteral("1/8")});
    auto* remove = new QPushButton(tr("Remove"), this);
    remove->setObjectName(prefix + QStringLiteral("remove"));
    remove->setAutoDefault(false);
    auto* top = new QHBoxLayout;
    top->setSpacing(8);
    top->addWidget(m_name, 1);
    top->addWidget(m_size);
    top->addWidget(remove);
    auto* channels = new QHBoxLayout;
    channels->setSpacing(8);
    const std::array<QString, 4> letters{tr("Red"), tr("Green"), tr("Blue"), tr("Alpha")};
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        m_channels[i] = new QComboBox(this);
        m_channels[i]->setObjectName(prefix + QStringLiteral("channel%1").arg(i));
        m_channels[i]->setAccessibleName(letters[i]);
        m_channels[i]->setToolTip(plainToolTip(letters[i]));
        m_channels[i]->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        m_channels[i]->setMinimumContentsLength(6);
        channels->addWidget(m_channels[i], 1);
    }
    fillChannels();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addLayout(top);
    layout->addLayout(channels);
    connect(m_name, &QLineEdit::textChanged, this, &PackRow::changed);
    connect(m_size, &QComboBox::currentIndexChanged, this, &PackRow::changed);
    connect(remove, &QPushButton::clicked, this, &PackRow::removed);
}

void PackRow::fillChannels()
{
    constexpr std::array<Pass, 3> kUsual{Pass::Shadow, Pass::Temperature, Pass::Alpha};
    const std::vector<PackedChannel> all = allChannels();
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        m_channels[i]->addItem(tr("Nothing"));
        for (const PackedChannel& channel : all) {
            m_channels[i]->addItem(toQString(textOf(channel)));
        }
        m_channels[i]->setCurrentText(i < kUsual.size() ? toQString(passName(kUsual[i])) : tr("Nothing"));
        connect(m_channels[i], &QComboBox::currentIndexChanged, this, &PackRow::changed);
    }
}

PackedPicture PackRow::pack() const
{
    const std::vector<PackedChannel> all = allChannels();
    PackedPicture out{
        m_name->text().trimmed().toStdString(), {}, kDivisors[static_cast<std::size_t>(m_size->currentIndex())]};
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        const int index = m_channels[i]->currentIndex(); // the first is none
        if (index > 0) {
            out.channels.resize(i + 1);
            out.channels[i] = all[static_cast<std::size_t>(index) - 1];
        }
    }
    return out;
}

void PackRow::take(const PackedPicture& pack)
{
    m_name->setText(toQString(pack.name));
    const auto divisor = std::ranges::find(kDivisors, pack.divisor);
    m_size->setCurrentIndex(divisor == kDivisors.end() ? 0 : static_cast<int>(divisor - kDivisors.begin()));
    const std::vector<PackedChannel> all = allChannels();
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        const auto found = i < pack.channels.size() ? std::ranges::find(all, pack.channels[i]) : all.end();
        m_channels[i]->setCurrentIndex(found == all.end() ? 0 : 1 + static_cast<int>(found - all.begin()));
    }
}

} // namespace fumage::ui
