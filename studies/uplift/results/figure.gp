set terminal svg size 760,360 font "Helvetica,13" background rgb "white"
set output "figure.svg"
set datafile separator ","
set multiplot layout 1,2
set border 3
set tics nomirror
set bmargin 6
set key at graph 0.5, graph -0.26 center top maxcols 2 samplen 2
set xlabel "i / i_c"
set arrow from 1, graph 0 to 1, graph 1 nohead dt 2 lc rgb "#888888"
set ylabel "force / buoyant weight"
set yrange [0:1.2]
plot "moments.csv" skip 1 using 1:3 with points pt 7 ps 0.4 lc rgb "#1f5fa8" title "fluid", \
     "moments.csv" skip 1 using 1:2 with points pt 7 ps 0.4 lc rgb "#c0504d" title "floor"
set ylabel "rise of the bed / diameter"
set yrange [*:*]
plot "moments.csv" skip 1 using 1:4 with points pt 7 ps 0.4 lc rgb "#1f5fa8" notitle
