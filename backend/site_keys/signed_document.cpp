// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/site_keys/signed_document.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QMap>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>
#include <utility>

namespace teleta::site_keys {

namespace {

struct DocumentText {
    Q_DECLARE_TR_FUNCTIONS(SiteKeys)
};

/// The texts of all elements that have no children, by name, below each `group`. Topics are named with what
/// is allowed: "publish topic".
std::optional<std::vector<QMap<QString, QStringList>>> groupsOf(const std::string& xml,
                                                                const QString& group) {
    QXmlStreamReader reader(QByteArray::fromStdString(xml));
    std::vector<QMap<QString, QStringList>> groups;
    QString name;
    QString text;
    QString action;
    while (!reader.atEnd()) {
        switch (reader.readNext()) {
        case QXmlStreamReader::StartElement:
            name = reader.name().toString();
            text.clear();
            if (name == group)
                groups.emplace_back();
            else if (name == u"publish" || name == u"subscribe" || name == u"relay")
                action = name;
            else if (name == u"deny_rule" && !groups.empty())
                groups.back()[name] << QString();
            break;
        case QXmlStreamReader::Characters:
            text += reader.text();
            break;
        case QXmlStreamReader::EndElement:
            if (reader.name() == name && !groups.empty())
                groups.back()[name == u"topic" ? action + QStringLiteral(" topic") : name] << text.trimmed();
            name.clear();
            break;
        default:
            break;
        }
    }
    if (reader.hasError())
        return std::nullopt;
    return groups;
}

/// "2026-01-01T00:00:00", in UTC.
std::optional<std::int64_t> timeOf(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^\\d{4}-\\d{2}-\\d{2}T\\d{2}:\\d{2}:\\d{2}$"));
    QDateTime time = QDateTime::fromString(text, Qt::ISODate);
    if (!form.match(text).hasMatch() || !time.isValid())
        return std::nullopt;
    time.setTimeSpec(Qt::UTC);
    return time.toSecsSinceEpoch();
}

/// "lab" of "rt/teleta/lab/console/console1/*"; empty for any other topic.
QString siteOf(const QString& topic) {
    static const QRegularExpression form(QStringLiteral("\\Art/teleta/([a-z][a-z0-9_]{0,30})/"));
    return form.match(topic).captured(1);
}

QStringList listOf(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts)
        list << QString::fromStdString(text);
    return list;
}

/// Compares the topics of a grant with those of the roles that the member may have.
void checkTopics(const QMap<QString, QStringList>& grant, const QString& member, PermissionsCheck& check) {
    const QStringList publish = grant.value(QStringLiteral("publish topic"));
    const QStringList subscribe = grant.value(QStringLiteral("subscribe topic"));
    QString site;
    for (const QString& topic : subscribe + publish)
        if (site.isEmpty())
            site = siteOf(topic);
    if (site.isEmpty()) {
        check.problems.push_back(
            DocumentText::tr("No topic of a site (rt/teleta/SITE/...) is allowed.").toStdString());
        return;
    }
    check.site = site.toStdString();
    const QString presence = QStringLiteral("rt/teleta/%1/console/%2/presence").arg(site, member);
    const MemberRole role = member == QLatin1String(kSiteMember) ? MemberRole::site
                            : publish.contains(presence)         ? MemberRole::viewer
                                                                 : MemberRole::console;
    const MemberTopics wanted = topicsOf(role, check.site, member.toStdString());
    const std::size_t before = check.problems.size();
    const auto compare = [&](const QStringList& allowed, const QStringList& needed, const QString& tooMuch,
                             const QString& tooLittle) {
        for (const QString& topic : allowed)
            if (!needed.contains(topic))
                check.problems.push_back(tooMuch.arg(member, topic).toStdString());
        for (const QString& topic : needed)
            if (!allowed.contains(topic))
                check.problems.push_back(tooLittle.arg(member, topic).toStdString());
    };
    compare(publish, listOf(wanted.publish), DocumentText::tr("%1 must not publish %2."),
            DocumentText::tr("%1 needs to publish %2."));
    compare(subscribe, listOf(wanted.subscribe), DocumentText::tr("%1 must not subscribe to %2."),
            DocumentText::tr("%1 needs to subscribe to %2."));
    compare(grant.value(QStringLiteral("relay topic")), {}, DocumentText::tr("%1 must not relay %2."), {});
    if (check.problems.size() == before)
        check.role = role;
}

} // namespace

MemberTopics topicsOf(MemberRole role, const std::string& site, const std::string& member) {
    const std::string all = "rt/teleta/" + site + '/';
    const std::string own = all + "console/" + member + '/';
    switch (role) {
    case MemberRole::site:
        return {{all + '*'}, {all + "console/*"}};
    case MemberRole::console:
        return {{own + '*'}, {all + '*'}};
    case MemberRole::viewer:
        break;
    }
    return {{own + "presence", own + "clock_probe"}, {all + '*'}};
}

PermissionsCheck checkPermissions(const std::string& xml, const std::string& member,
                                  const std::string& subject, std::int64_t now_unixS) {
    PermissionsCheck check;
    const auto say = [&](const QString& text) { check.problems.push_back(text.toStdString()); };
    const auto grants = groupsOf(xml, QStringLiteral("grant"));
    if (!grants) {
        say(DocumentText::tr("The signed document is not XML."));
        return check;
    }
    bool named = false;
    for (const QMap<QString, QStringList>& grant : *grants) {
        if (grant.value(QStringLiteral("subject_name")) != QStringList{QString::fromStdString(subject)})
            continue;
        named = true;
        const auto begin = timeOf(grant.value(QStringLiteral("not_before")).value(0));
        const auto end = timeOf(grant.value(QStringLiteral("not_after")).value(0));
        if (!begin || !end)
            say(DocumentText::tr(
                "The validity needs not_before and not_after as 2026-01-31T00:00:00, without a time zone."));
        else if (now_unixS < *begin)
            say(DocumentText::tr("The permissions are not valid yet."));
        else if (now_unixS >= *end)
            say(DocumentText::tr("The permissions have expired."));
        else
            check.ends_unixS = *end;
        checkTopics(grant, QString::fromStdString(member), check);
        if (grant.contains(QStringLiteral("deny_rule")))
            say(DocumentText::tr("The grant has a deny_rule. It needs none: what is not allowed is denied."));
        if (grant.value(QStringLiteral("default")) != QStringList{QStringLiteral("DENY")})
            say(DocumentText::tr("The default of the grant is not DENY."));
    }
    if (!named)
        say(DocumentText::tr("No grant names the subject of the certificate, %1.")
                .arg(QString::fromStdString(subject)));
    return check;
}

std::vector<std::string> checkGovernance(const std::string& xml) {
    static const std::pair<const char*, const char*> wanted[] = {
        {"allow_unauthenticated_participants", "false"},
        {"enable_join_access_control", "true"},
        {"discovery_protection_kind", "ENCRYPT"},
        {"liveliness_protection_kind", "ENCRYPT"},
        {"rtps_protection_kind", "SIGN"},
        {"enable_discovery_protection", "true"},
        {"enable_liveliness_protection", "true"},
        {"enable_read_access_control", "true"},
        {"enable_write_access_control", "true"},
        {"data_protection_kind", "ENCRYPT"}};
    const auto rules = groupsOf(xml, QStringLiteral("domain_rule"));
    if (!rules || rules->empty())
        return {DocumentText::tr("The signed document has no domain_rule.").toStdString()};
    std::vector<std::string> problems;
    for (const QMap<QString, QStringList>& rule : *rules)
        for (const auto& [name, value] : wanted) {
            const QStringList told = rule.value(QLatin1String(name));
            QStringList others = told;
            others.removeAll(QLatin1String(value));
            if (told.isEmpty() || !others.isEmpty())
                problems.push_back(DocumentText::tr("%1 must be %2.")
                                       .arg(QLatin1String(name), QLatin1String(value))
                                       .toStdString());
        }
    return problems;
}

} // namespace teleta::site_keys
