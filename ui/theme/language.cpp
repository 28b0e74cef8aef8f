#include "ui/theme/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace fumage::ui {

const QList<Language>& languages()
{
    static const QList<Language> all{{QStringLiteral("en"), QStringLiteral("English")},
        {QStringLiteral("sv"), QStringLiteral("Svenska")}, {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
    return all;
}

bool applyLanguage(QCoreApplication& application, const QString& code)
{
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    QLocale::setDefault(locale);
    if (locale.language() == QLocale::English) {
        return true;
    }
    auto* own = new QTranslator(&application);
    if (!own->load(locale, QStringLiteral("fumage"), QStringLiteral("_"), QStringLiteral(":/translations"))) {
        delete own;
        return false;
    }
    QCoreApplication::installTranslator(own);
    // Buttons and dialogs of Qt, where its translations are installed, or within the program.
    auto* qt = new QTranslator(&application);
    for (const QString& folder :
        {QLibraryInfo::path(QLibraryInfo::TranslationsPath), QStringLiteral(":/translations")}) {
        if (qt->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), folder)) {
            QCoreApplication::installTranslator(qt);
            break;
        }
    }
    return true;
}

} // namespace fumage::ui
