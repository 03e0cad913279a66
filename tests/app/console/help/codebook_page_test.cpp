// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook's page "Codebook" is made from the table of columns. This test fails when a page that is kept
// in resources/handbook differs from it; run with TELETA_WRITE_PAGES=1, it writes the pages anew.
#include "backend/study/report/exports/codebook.h"

#include <QFile>
#include <QTest>

#include <vector>

using namespace teleta;

namespace {

struct PageWords {
    const char* language;
    const char* title;
    const char* intro;
};

const std::vector<PageWords>& pages() {
    static const std::vector<PageWords> kPages{
        {"en", "Codebook",
         "Every column of the tables that studies write. `trials`, `questionnaire` and `notes` are the "
         "tables "
         "of these kinds in every export, `phenotype` the first columns of the tables of questionnaires in "
         "BIDS; the other names are those of files. `teleta study codebook` writes this page as CSV, and "
         "every "
         "export of a study has it as `codebook.csv`, with the study's own questionnaires."},
        {"fr", "Dictionnaire des données",
         "Toutes les colonnes des tableaux que les études écrivent. `trials`, `questionnaire` et `notes` "
         "sont "
         "les tableaux de ces genres dans chaque exportation, `phenotype` les premières colonnes des "
         "tableaux "
         "de questionnaires en BIDS ; les autres noms sont ceux de fichiers. `teleta study codebook` écrit "
         "cette page en CSV, et chaque exportation d'une étude la contient sous le nom `codebook.csv`, avec "
         "les questionnaires de l'étude. Les tableaux sont en anglais."},
        {"ja", "コードブック",
         "実験が書き出す表のすべての列です。`trials`、`questionnaire`、`notes` "
         "は各書き出し形式のその種類の表、"
         "`phenotype` は BIDS の質問紙の表の最初の列を指し、その他はファイル名です。`teleta study codebook` "
         "はこのページを CSV で書き出します。実験の書き出しには、その実験の質問紙を加えた `codebook.csv` "
         "が含まれます。表は英語です。"},
        {"zh_CN", "数据字典",
         "研究写出的各个表的所有列。`trials`、`questionnaire` 和 `notes` "
         "指各种导出格式中的这几类表，`phenotype` 指 "
         "BIDS 问卷表的前几列，其他名称都是文件名。`teleta study codebook` 把本页写成 "
         "CSV；每次导出研究时都会附上 `codebook.csv`，其中还有该研究自己的问卷。表格为英文。"}};
    return kPages;
}

QByteArray pageOf(const PageWords& words) {
    return QByteArray("# ") + words.title + "\n\n" + words.intro + "\n" +
           QByteArray::fromStdString(study::codebookPage());
}

} // namespace

class CodebookPageTest : public QObject {
    Q_OBJECT

private slots:
    void isWhatTheTableHas() {
        for (const PageWords& words : pages()) {
            QFile file(QStringLiteral(TELETA_SOURCE_DIR "/resources/handbook/%1/codebook.md")
                           .arg(QLatin1String(words.language)));
            if (qEnvironmentVariableIsSet("TELETA_WRITE_PAGES")) {
                QVERIFY(file.open(QIODevice::WriteOnly));
                file.write(pageOf(words));
                continue;
            }
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            QVERIFY2(file.readAll() == pageOf(words),
                     qPrintable(file.fileName() +
                                " is not what the table has: run this test with TELETA_WRITE_PAGES=1"));
        }
    }
};

QTEST_GUILESS_MAIN(CodebookPageTest)
#include "codebook_page_test.moc"
