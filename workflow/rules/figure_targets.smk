"""A target for each figure, and one for all."""


rule figures:
    input:
        FIGURES,
    message:
        "All figures are drawn."


rule fig01:
    input:
        rules.plot_fig01.output,
    message:
        "Figure 1 is drawn."


rule fig02:
    input:
        rules.plot_fig02.output,
    message:
        "Figure 2 is drawn."


rule fig03:
    input:
        rules.plot_fig03.output,
    message:
        "Figure 3 is drawn."


rule fig04:
    input:
        rules.plot_fig04.output,
    message:
        "Figure 4 is drawn."


rule fig05:
    input:
        rules.plot_fig05.output,
    message:
        "Figure 5 is drawn."


rule fig06:
    input:
        rules.plot_fig06.output,
    message:
        "Figure 6 is drawn."


rule fig07:
    input:
        rules.plot_fig07.output,
    message:
        "Figure 7 is drawn."


rule fig07b:
    input:
        rules.plot_fig07b.output,
    message:
        "Figure 7b is drawn."


rule fig08:
    input:
        rules.plot_fig08.output,
    message:
        "Figure 8 is drawn."


rule fig09:
    input:
        rules.plot_fig09.output,
    message:
        "Figure 9 is drawn."


rule fig10:
    input:
        rules.plot_fig10.output,
    message:
        "Figure 10 is drawn."


rule fig11:
    input:
        rules.plot_fig11.output,
    message:
        "Figure 11 is drawn."


rule fig12:
    input:
        rules.plot_fig12.output,
    message:
        "Figure 12 is drawn."


rule fig13:
    input:
        rules.plot_fig13.output,
    message:
        "Figure 13 is drawn."


rule fig17:
    input:
        rules.plot_fig17.output,
    message:
        "Figure 17 is drawn."


rule fig18:
    input:
        rules.plot_fig18.output,
    message:
        "Figure 18 is drawn."


rule fig19:
    input:
        rules.plot_fig19.output,
    message:
        "Figure 19 is drawn."
